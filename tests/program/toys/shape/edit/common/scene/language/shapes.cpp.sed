/^const CommandRow rows\[\] = {/a\
    {{"ball", "x y z r", "A sphere by another name.", "97"},\
     [](Parser& p) {\
         add_object(p, Ball{vec3(p, 1), positive(p, 4, "half the width")});\
     }},
