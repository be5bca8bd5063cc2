s/^enum class Integrator {.*[A-Za-z]/&, Silhouette/
/^inline constexpr IntegratorRow integrators\[\] = {/,/^};/s/^};/    {.value = Integrator::Silhouette,\
     .name = "silhouette",\
     .meaning = "white where anything is",\
     .chapter = "01",\
     .why_not_povray = "it has no silhouettes"},\
&/
