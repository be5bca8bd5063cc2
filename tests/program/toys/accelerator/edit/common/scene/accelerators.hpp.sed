s/^enum class AcceleratorChoice {.*Nested/&, Boxes/
/^inline constexpr AcceleratorWord accelerator_words\[\] = {/,/^};/s/^};/    {"boxes", AcceleratorChoice::Boxes, "a box around each shape", "96"},\
&/
