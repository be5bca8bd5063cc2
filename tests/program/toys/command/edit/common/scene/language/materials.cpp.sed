/^const CommandRow rows\[\] = {/a\
    {{"brightness", "f", "For the objects that follow: factor on ambient and emission; default 1.", "97"},\
     [](Parser\& p) { p.material.brightness = sized(p, 1, "the brightness"); }},
