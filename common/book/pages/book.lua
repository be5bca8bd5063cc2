-- What pandoc makes of a lesson: links within the book, figures with their captions, boxes, steps.
-- Metadata: `source` and `root` are the page's path and the repository's, and `pages` has the book's pages by path.
-- What the page needs is noted in a last comment: "picture PATH", "file PATH" or "missing PATH", a line each.
local source, root, pages
local wanted = {}

local function meta(m)
  source = pandoc.utils.stringify(m.source)
  root = pandoc.utils.stringify(m.root)
  pages = {}
  for path, file in pairs(m.pages) do pages[path] = pandoc.utils.stringify(file) end
  return {}
end

-- The path from the repository's root that a link of this page means.
local function resolved(target)
  local parts = {}
  for part in (source:match("(.*/)") .. target):gmatch("[^/]+") do
    if part == ".." then table.remove(parts) elseif part ~= "." then table.insert(parts, part) end
  end
  return table.concat(parts, "/")
end

local function is_file(path)
  local file = io.open(root .. "/" .. path, "r")
  local found = file ~= nil and file:read(0) ~= nil or false
  if file then file:close() end
  return found
end

local function note(kind, path) table.insert(wanted, kind .. " " .. path) end

local function link(element)
  local target, anchor = element.target:match("^([^#]*)(#?.*)$")
  if target == "" or target:find("://") or target:find("^mailto:") then return nil end
  local path = resolved(target)
  if pages[path] then
    element.target = pages[path] .. anchor
    return element
  end
  -- A student's own file, and a directory, are where the course is, not in the book.
  if path:find("^chapters/.*%.cpp$") then return element.content end
  if not is_file(path) then
    local directory = io.open(root .. "/" .. path, "r")
    if directory then directory:close() else note("missing", path) end
    return element.content
  end
  note("file", path)
  element.target = "files/" .. path .. ".html"
  return element
end

local function image(element)
  if element.src:find("://") then return nil end
  local path = resolved(element.src)
  note(is_file(path) and "picture" or "missing", path)
  element.src = path
  element.attributes.loading = "lazy"
  return element
end

local function raw(element)
  if element.format == "html" and element.text:find("^%s*<!%-%-") then return {} end
end

local function wide(element) return pandoc.Div({element}, {class = "scroll", tabindex = "0"}) end

local function begins(block, tag, pattern)
  if not block or (block.t ~= "Para" and block.t ~= "Plain") then return nil end
  local first = block.content[1]
  return first and first.t == tag and pandoc.utils.stringify(first):match(pattern)
end

local function is_picture(block)
  return block.t == "Para" and #block.content == 1 and block.content[1].t == "Image"
    or block.t == "Div" and block.classes:includes("scroll")
end

-- A picture, or a table of them, and the caption below it.
local function blocks(list)
  local result = pandoc.List()
  local i = 1
  while i <= #list do
    local block, caption = list[i], list[i + 1]
    local number = is_picture(block) and begins(caption, "Emph", "^Figure (%d+%.%d+)%.")
    if number then
      result:insert(pandoc.Div({block, pandoc.Div({caption}, {class = "caption"})},
        {class = "figure", id = "figure-" .. number, role = "group"}))
      i = i + 1
    else
      local step = begins(block, "Strong", "^Now write (%d%d%.%d+)$")
      if step then block = pandoc.Div({block}, {class = "task", id = "step-" .. step}) end
      result:insert(block)
    end
    i = i + 1
  end
  return result
end

local function quotation(element)
  if begins(element.content[1], "Strong", "^For the curious") then
    return pandoc.Div(element.content, {class = "curious", role = "note"})
  end
end

local function add_notes(document)
  document.blocks:insert(pandoc.RawBlock("html", "<!-- wanted\n" .. table.concat(wanted, "\n") .. "\n-->"))
  return document
end

return {
  {Meta = meta},
  {RawInline = raw, RawBlock = raw, Link = link, Image = image, Table = wide},
  {BlockQuote = quotation, Blocks = blocks},
  {Pandoc = add_notes},
}
