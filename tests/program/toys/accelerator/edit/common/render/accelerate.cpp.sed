/^            case AcceleratorChoice::None:/i\
            case AcceleratorChoice::Boxes:\
                return Boxes{boxed.bounds};
