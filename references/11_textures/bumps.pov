// bumps.scene, written by `course export`.
// povray +Ibumps.pov +Obumps.png +W200 +H150 +FN16 -D -A File_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 1 adc_bailout 0 }
background { rgb <0.5, 0.58, 0.66> }

camera {
  perspective
  location <0, 2.6, 7>
  direction <0, -0.25551291947697685, -0.9668056412642367>
  right <0.789902653232214, 0, 0>
  up <0, 0.5727617558958695, -0.1513727497724798>
}

light_source { <-4, 6, 5> rgb <0.85, 0.83, 0.8> }
light_source { <75809.80435789035, 53066.863050523236, 37904.90217894517> rgb <0.16, 0.17, 0.2> parallel point_at 0 }

#declare PermutedTable = function { pigment { gradient x color_map {
  [0.001953125 rgb 0.592156862745098] [0.005859375 rgb 0.6274509803921569] [0.009765625 rgb 0.5372549019607843] [0.013671875 rgb 0.3568627450980392] [0.017578125 rgb 0.35294117647058826] [0.021484375 rgb 0.058823529411764705] [0.025390625 rgb 0.5137254901960784] [0.029296875 rgb 0.050980392156862744]
  [0.033203125 rgb 0.788235294117647] [0.037109375 rgb 0.37254901960784315] [0.041015625 rgb 0.3764705882352941] [0.044921875 rgb 0.20784313725490197] [0.048828125 rgb 0.7607843137254902] [0.052734375 rgb 0.9137254901960784] [0.056640625 rgb 0.027450980392156862] [0.060546875 rgb 0.8823529411764706]
  [0.064453125 rgb 0.5490196078431373] [0.068359375 rgb 0.1411764705882353] [0.072265625 rgb 0.403921568627451] [0.076171875 rgb 0.11764705882352941] [0.080078125 rgb 0.27058823529411763] [0.083984375 rgb 0.5568627450980392] [0.087890625 rgb 0.03137254901960784] [0.091796875 rgb 0.38823529411764707]
  [0.095703125 rgb 0.1450980392156863] [0.099609375 rgb 0.9411764705882353] [0.103515625 rgb 0.08235294117647059] [0.107421875 rgb 0.0392156862745098] [0.111328125 rgb 0.09019607843137255] [0.115234375 rgb 0.7450980392156863] [0.119140625 rgb 0.023529411764705882] [0.123046875 rgb 0.5803921568627451]
  [0.126953125 rgb 0.9686274509803922] [0.130859375 rgb 0.47058823529411764] [0.134765625 rgb 0.9176470588235294] [0.138671875 rgb 0.29411764705882354] [0.142578125 rgb 0] [0.146484375 rgb 0.10196078431372549] [0.150390625 rgb 0.7725490196078432] [0.154296875 rgb 0.24313725490196078]
  [0.158203125 rgb 0.3686274509803922] [0.162109375 rgb 0.9882352941176471] [0.166015625 rgb 0.8588235294117647] [0.169921875 rgb 0.796078431372549] [0.173828125 rgb 0.4588235294117647] [0.177734375 rgb 0.13725490196078433] [0.181640625 rgb 0.043137254901960784] [0.185546875 rgb 0.12549019607843137]
  [0.189453125 rgb 0.2235294117647059] [0.193359375 rgb 0.6941176470588235] [0.197265625 rgb 0.12941176470588237] [0.201171875 rgb 0.34509803921568627] [0.205078125 rgb 0.9294117647058824] [0.208984375 rgb 0.5843137254901961] [0.212890625 rgb 0.2196078431372549] [0.216796875 rgb 0.3411764705882353]
  [0.220703125 rgb 0.6823529411764706] [0.224609375 rgb 0.0784313725490196] [0.228515625 rgb 0.49019607843137253] [0.232421875 rgb 0.5333333333333333] [0.236328125 rgb 0.6705882352941176] [0.240234375 rgb 0.6588235294117647] [0.244140625 rgb 0.26666666666666666] [0.248046875 rgb 0.6862745098039216]
  [0.251953125 rgb 0.2901960784313726] [0.255859375 rgb 0.6470588235294118] [0.259765625 rgb 0.2784313725490196] [0.263671875 rgb 0.5254901960784314] [0.267578125 rgb 0.5450980392156862] [0.271484375 rgb 0.18823529411764706] [0.275390625 rgb 0.10588235294117647] [0.279296875 rgb 0.6509803921568628]
  [0.283203125 rgb 0.30196078431372547] [0.287109375 rgb 0.5725490196078431] [0.291015625 rgb 0.6196078431372549] [0.294921875 rgb 0.9058823529411765] [0.298828125 rgb 0.3254901960784314] [0.302734375 rgb 0.43529411764705883] [0.306640625 rgb 0.8980392156862745] [0.310546875 rgb 0.47843137254901963]
  [0.314453125 rgb 0.23529411764705882] [0.318359375 rgb 0.8274509803921568] [0.322265625 rgb 0.5215686274509804] [0.326171875 rgb 0.9019607843137255] [0.330078125 rgb 0.8627450980392157] [0.333984375 rgb 0.4117647058823529] [0.337890625 rgb 0.3607843137254902] [0.341796875 rgb 0.1607843137254902]
  [0.345703125 rgb 0.21568627450980393] [0.349609375 rgb 0.1803921568627451] [0.353515625 rgb 0.9607843137254902] [0.357421875 rgb 0.1568627450980392] [0.361328125 rgb 0.9568627450980393] [0.365234375 rgb 0.4] [0.369140625 rgb 0.5607843137254902] [0.373046875 rgb 0.21176470588235294]
  [0.376953125 rgb 0.2549019607843137] [0.380859375 rgb 0.09803921568627451] [0.384765625 rgb 0.24705882352941178] [0.388671875 rgb 0.6313725490196078] [0.392578125 rgb 0.00392156862745098] [0.396484375 rgb 0.8470588235294118] [0.400390625 rgb 0.3137254901960784] [0.404296875 rgb 0.28627450980392155]
  [0.408203125 rgb 0.8196078431372549] [0.412109375 rgb 0.2980392156862745] [0.416015625 rgb 0.5176470588235295] [0.419921875 rgb 0.7333333333333333] [0.423828125 rgb 0.8156862745098039] [0.427734375 rgb 0.34901960784313724] [0.431640625 rgb 0.07058823529411765] [0.435546875 rgb 0.6627450980392157]
  [0.439453125 rgb 0.7843137254901961] [0.443359375 rgb 0.7686274509803922] [0.447265625 rgb 0.5294117647058824] [0.451171875 rgb 0.5098039215686274] [0.455078125 rgb 0.4549019607843137] [0.458984375 rgb 0.7372549019607844] [0.462890625 rgb 0.6235294117647059] [0.466796875 rgb 0.33725490196078434]
  [0.470703125 rgb 0.6431372549019608] [0.474609375 rgb 0.39215686274509803] [0.478515625 rgb 0.42745098039215684] [0.482421875 rgb 0.7764705882352941] [0.486328125 rgb 0.6784313725490196] [0.490234375 rgb 0.7294117647058823] [0.494140625 rgb 0.011764705882352941] [0.498046875 rgb 0.25098039215686274]
  [0.501953125 rgb 0.20392156862745098] [0.505859375 rgb 0.8509803921568627] [0.509765625 rgb 0.8862745098039215] [0.513671875 rgb 0.9803921568627451] [0.517578125 rgb 0.48627450980392156] [0.521484375 rgb 0.4823529411764706] [0.525390625 rgb 0.0196078431372549] [0.529296875 rgb 0.792156862745098]
  [0.533203125 rgb 0.14901960784313725] [0.537109375 rgb 0.5764705882352941] [0.541015625 rgb 0.4627450980392157] [0.544921875 rgb 0.49411764705882355] [0.548828125 rgb 1] [0.552734375 rgb 0.3215686274509804] [0.556640625 rgb 0.3333333333333333] [0.560546875 rgb 0.8313725490196079]
  [0.564453125 rgb 0.8117647058823529] [0.568359375 rgb 0.807843137254902] [0.572265625 rgb 0.23137254901960785] [0.576171875 rgb 0.8901960784313725] [0.580078125 rgb 0.1843137254901961] [0.583984375 rgb 0.06274509803921569] [0.587890625 rgb 0.22745098039215686] [0.591796875 rgb 0.06666666666666667]
  [0.595703125 rgb 0.7137254901960784] [0.599609375 rgb 0.7411764705882353] [0.603515625 rgb 0.10980392156862745] [0.607421875 rgb 0.16470588235294117] [0.611328125 rgb 0.8745098039215686] [0.615234375 rgb 0.7176470588235294] [0.619140625 rgb 0.6666666666666666] [0.623046875 rgb 0.8352941176470589]
  [0.626953125 rgb 0.4666666666666667] [0.630859375 rgb 0.9725490196078431] [0.634765625 rgb 0.596078431372549] [0.638671875 rgb 0.00784313725490196] [0.642578125 rgb 0.17254901960784313] [0.646484375 rgb 0.6039215686274509] [0.650390625 rgb 0.6392156862745098] [0.654296875 rgb 0.27450980392156865]
  [0.658203125 rgb 0.8666666666666667] [0.662109375 rgb 0.6] [0.666015625 rgb 0.396078431372549] [0.669921875 rgb 0.6078431372549019] [0.673828125 rgb 0.6549019607843137] [0.677734375 rgb 0.16862745098039217] [0.681640625 rgb 0.6745098039215687] [0.685546875 rgb 0.03529411764705882]
  [0.689453125 rgb 0.5058823529411764] [0.693359375 rgb 0.08627450980392157] [0.697265625 rgb 0.15294117647058825] [0.701171875 rgb 0.9921568627450981] [0.705078125 rgb 0.07450980392156863] [0.708984375 rgb 0.3843137254901961] [0.712890625 rgb 0.4235294117647059] [0.716796875 rgb 0.43137254901960786]
  [0.720703125 rgb 0.30980392156862746] [0.724609375 rgb 0.44313725490196076] [0.728515625 rgb 0.8784313725490196] [0.732421875 rgb 0.9098039215686274] [0.736328125 rgb 0.6980392156862745] [0.740234375 rgb 0.7254901960784313] [0.744140625 rgb 0.4392156862745098] [0.748046875 rgb 0.40784313725490196]
  [0.751953125 rgb 0.8549019607843137] [0.755859375 rgb 0.9647058823529412] [0.759765625 rgb 0.3803921568627451] [0.763671875 rgb 0.8941176470588236] [0.767578125 rgb 0.984313725490196] [0.771484375 rgb 0.13333333333333333] [0.775390625 rgb 0.9490196078431372] [0.779296875 rgb 0.7568627450980392]
  [0.783203125 rgb 0.9333333333333333] [0.787109375 rgb 0.8235294117647058] [0.791015625 rgb 0.5647058823529412] [0.794921875 rgb 0.047058823529411764] [0.798828125 rgb 0.7490196078431373] [0.802734375 rgb 0.7019607843137254] [0.806640625 rgb 0.6352941176470588] [0.810546875 rgb 0.9450980392156862]
  [0.814453125 rgb 0.3176470588235294] [0.818359375 rgb 0.2] [0.822265625 rgb 0.5686274509803921] [0.826171875 rgb 0.9215686274509803] [0.830078125 rgb 0.9764705882352941] [0.833984375 rgb 0.054901960784313725] [0.837890625 rgb 0.9372549019607843] [0.841796875 rgb 0.4196078431372549]
  [0.845703125 rgb 0.19215686274509805] [0.849609375 rgb 0.7529411764705882] [0.853515625 rgb 0.8392156862745098] [0.857421875 rgb 0.12156862745098039] [0.861328125 rgb 0.7098039215686275] [0.865234375 rgb 0.7803921568627451] [0.869140625 rgb 0.41568627450980394] [0.873046875 rgb 0.615686274509804]
  [0.876953125 rgb 0.7215686274509804] [0.880859375 rgb 0.32941176470588235] [0.884765625 rgb 0.8] [0.888671875 rgb 0.6901960784313725] [0.892578125 rgb 0.45098039215686275] [0.896484375 rgb 0.4745098039215686] [0.900390625 rgb 0.19607843137254902] [0.904296875 rgb 0.17647058823529413]
  [0.908203125 rgb 0.4980392156862745] [0.912109375 rgb 0.01568627450980392] [0.916015625 rgb 0.5882352941176471] [0.919921875 rgb 0.996078431372549] [0.923828125 rgb 0.5411764705882353] [0.927734375 rgb 0.9254901960784314] [0.931640625 rgb 0.803921568627451] [0.935546875 rgb 0.36470588235294116]
  [0.939453125 rgb 0.8705882352941177] [0.943359375 rgb 0.4470588235294118] [0.947265625 rgb 0.2627450980392157] [0.951171875 rgb 0.11372549019607843] [0.955078125 rgb 0.09411764705882353] [0.958984375 rgb 0.2823529411764706] [0.962890625 rgb 0.9529411764705882] [0.966796875 rgb 0.5529411764705883]
  [0.970703125 rgb 0.5019607843137255] [0.974609375 rgb 0.7647058823529411] [0.978515625 rgb 0.3058823529411765] [0.982421875 rgb 0.25882352941176473] [0.986328125 rgb 0.8431372549019608] [0.990234375 rgb 0.23921568627450981] [0.994140625 rgb 0.611764705882353] [0.998046875 rgb 0.7058823529411765] } } }
#declare GradientTable = function { pigment { gradient x color_map {
  [0.001953125 rgb <0, 0.5, 0>] [0.005859375 rgb <1, 1, 0.5>] [0.009765625 rgb <0.5, 0, 1>] [0.013671875 rgb <0.5, 0, 0>] [0.017578125 rgb <0.5, 1, 0>] [0.021484375 rgb <0.5, 0, 0>] [0.025390625 rgb <0, 0, 0.5>] [0.029296875 rgb <0.5, 0, 1>]
  [0.033203125 rgb <0.5, 0, 1>] [0.037109375 rgb <0.5, 0, 0>] [0.041015625 rgb <1, 1, 0.5>] [0.044921875 rgb <0, 0.5, 1>] [0.048828125 rgb <1, 0, 0.5>] [0.052734375 rgb <0.5, 0, 1>] [0.056640625 rgb <0, 0.5, 0>] [0.060546875 rgb <0, 1, 0.5>]
  [0.064453125 rgb <1, 1, 0.5>] [0.068359375 rgb <1, 0.5, 1>] [0.072265625 rgb <0, 0.5, 0>] [0.076171875 rgb <0, 1, 0.5>] [0.080078125 rgb <0, 0.5, 1>] [0.083984375 rgb <0, 1, 0.5>] [0.087890625 rgb <0.5, 1, 1>] [0.091796875 rgb <0, 0, 0.5>]
  [0.095703125 rgb <0, 0.5, 1>] [0.099609375 rgb <1, 1, 0.5>] [0.103515625 rgb <0, 0.5, 1>] [0.107421875 rgb <0.5, 1, 0>] [0.111328125 rgb <0, 0.5, 0>] [0.115234375 rgb <0, 1, 0.5>] [0.119140625 rgb <1, 0.5, 0>] [0.123046875 rgb <1, 0.5, 1>]
  [0.126953125 rgb <0, 0.5, 0>] [0.130859375 rgb <0.5, 1, 1>] [0.134765625 rgb <0.5, 1, 0>] [0.138671875 rgb <0.5, 0, 0>] [0.142578125 rgb <1, 1, 0.5>] [0.146484375 rgb <0.5, 1, 0>] [0.150390625 rgb <0, 0.5, 1>] [0.154296875 rgb <0, 1, 0.5>]
  [0.158203125 rgb <0, 1, 0.5>] [0.162109375 rgb <1, 1, 0.5>] [0.166015625 rgb <0.5, 0, 0>] [0.169921875 rgb <0.5, 0, 0>] [0.173828125 rgb <0, 0.5, 1>] [0.177734375 rgb <0, 0, 0.5>] [0.181640625 rgb <0.5, 0, 0>] [0.185546875 rgb <1, 1, 0.5>]
  [0.189453125 rgb <0.5, 0, 1>] [0.193359375 rgb <0, 1, 0.5>] [0.197265625 rgb <0, 1, 0.5>] [0.201171875 rgb <0.5, 1, 1>] [0.205078125 rgb <0.5, 0, 1>] [0.208984375 rgb <0, 0.5, 1>] [0.212890625 rgb <0.5, 1, 1>] [0.216796875 rgb <0, 0.5, 0>]
  [0.220703125 rgb <0, 1, 0.5>] [0.224609375 rgb <1, 0.5, 1>] [0.228515625 rgb <0.5, 0, 1>] [0.232421875 rgb <0.5, 1, 1>] [0.236328125 rgb <0.5, 0, 0>] [0.240234375 rgb <0.5, 1, 1>] [0.244140625 rgb <1, 0.5, 1>] [0.248046875 rgb <0.5, 0, 0>]
  [0.251953125 rgb <0.5, 1, 0>] [0.255859375 rgb <0, 0.5, 1>] [0.259765625 rgb <0, 0.5, 0>] [0.263671875 rgb <1, 0.5, 0>] [0.267578125 rgb <0.5, 0, 0>] [0.271484375 rgb <1, 1, 0.5>] [0.275390625 rgb <0.5, 0, 0>] [0.279296875 rgb <1, 0.5, 0>]
  [0.283203125 rgb <0.5, 0, 1>] [0.287109375 rgb <1, 0, 0.5>] [0.291015625 rgb <0, 1, 0.5>] [0.294921875 rgb <0, 0.5, 0>] [0.298828125 rgb <0, 0, 0.5>] [0.302734375 rgb <0.5, 0, 0>] [0.306640625 rgb <0, 0.5, 1>] [0.310546875 rgb <0.5, 1, 0>]
  [0.314453125 rgb <1, 1, 0.5>] [0.318359375 rgb <0, 0, 0.5>] [0.322265625 rgb <0, 0.5, 1>] [0.326171875 rgb <1, 0.5, 0>] [0.330078125 rgb <1, 1, 0.5>] [0.333984375 rgb <0.5, 0, 1>] [0.337890625 rgb <1, 1, 0.5>] [0.341796875 rgb <0.5, 0, 1>]
  [0.345703125 rgb <0, 0.5, 0>] [0.349609375 rgb <0, 1, 0.5>] [0.353515625 rgb <0, 0.5, 1>] [0.357421875 rgb <0.5, 1, 1>] [0.361328125 rgb <1, 0.5, 1>] [0.365234375 rgb <1, 0.5, 0>] [0.369140625 rgb <0.5, 0, 0>] [0.373046875 rgb <1, 0.5, 0>]
  [0.376953125 rgb <0, 1, 0.5>] [0.380859375 rgb <0.5, 0, 1>] [0.384765625 rgb <0.5, 0, 0>] [0.388671875 rgb <0, 1, 0.5>] [0.392578125 rgb <0, 1, 0.5>] [0.396484375 rgb <0.5, 1, 1>] [0.400390625 rgb <1, 1, 0.5>] [0.404296875 rgb <0.5, 0, 1>]
  [0.408203125 rgb <0, 1, 0.5>] [0.412109375 rgb <1, 1, 0.5>] [0.416015625 rgb <1, 0.5, 1>] [0.419921875 rgb <0.5, 0, 0>] [0.423828125 rgb <1, 1, 0.5>] [0.427734375 rgb <0.5, 0, 1>] [0.431640625 rgb <1, 0, 0.5>] [0.435546875 rgb <0.5, 0, 1>]
  [0.439453125 rgb <0.5, 1, 1>] [0.443359375 rgb <1, 0.5, 1>] [0.447265625 rgb <0, 0.5, 0>] [0.451171875 rgb <1, 0, 0.5>] [0.455078125 rgb <1, 0.5, 1>] [0.458984375 rgb <1, 1, 0.5>] [0.462890625 rgb <0.5, 0, 0>] [0.466796875 rgb <1, 0.5, 0>]
  [0.470703125 rgb <1, 0.5, 1>] [0.474609375 rgb <1, 0.5, 1>] [0.478515625 rgb <0.5, 0, 1>] [0.482421875 rgb <1, 0.5, 0>] [0.486328125 rgb <0.5, 0, 1>] [0.490234375 rgb <0.5, 1, 0>] [0.494140625 rgb <0, 0, 0.5>] [0.498046875 rgb <1, 1, 0.5>]
  [0.501953125 rgb <1, 0.5, 1>] [0.505859375 rgb <0.5, 0, 1>] [0.509765625 rgb <1, 0, 0.5>] [0.513671875 rgb <0.5, 1, 0>] [0.517578125 rgb <1, 1, 0.5>] [0.521484375 rgb <0.5, 0, 0>] [0.525390625 rgb <0, 0.5, 1>] [0.529296875 rgb <0.5, 1, 0>]
  [0.533203125 rgb <1, 0.5, 0>] [0.537109375 rgb <0, 0, 0.5>] [0.541015625 rgb <1, 0.5, 0>] [0.544921875 rgb <0, 1, 0.5>] [0.548828125 rgb <0.5, 0, 0>] [0.552734375 rgb <1, 0, 0.5>] [0.556640625 rgb <0, 0.5, 1>] [0.560546875 rgb <1, 0.5, 1>]
  [0.564453125 rgb <0.5, 0, 0>] [0.568359375 rgb <0, 1, 0.5>] [0.572265625 rgb <0.5, 0, 0>] [0.576171875 rgb <0, 0, 0.5>] [0.580078125 rgb <0.5, 0, 0>] [0.583984375 rgb <1, 1, 0.5>] [0.587890625 rgb <0.5, 1, 0>] [0.591796875 rgb <0, 1, 0.5>]
  [0.595703125 rgb <1, 0.5, 0>] [0.599609375 rgb <0.5, 0, 1>] [0.603515625 rgb <1, 1, 0.5>] [0.607421875 rgb <0.5, 1, 0>] [0.611328125 rgb <0.5, 0, 0>] [0.615234375 rgb <0, 0.5, 0>] [0.619140625 rgb <0.5, 1, 0>] [0.623046875 rgb <0, 0.5, 1>]
  [0.626953125 rgb <0, 0.5, 0>] [0.630859375 rgb <0.5, 1, 1>] [0.634765625 rgb <0.5, 1, 1>] [0.638671875 rgb <1, 0, 0.5>] [0.642578125 rgb <1, 1, 0.5>] [0.646484375 rgb <0.5, 1, 0>] [0.650390625 rgb <0, 0, 0.5>] [0.654296875 rgb <1, 0.5, 0>]
  [0.658203125 rgb <0.5, 0, 1>] [0.662109375 rgb <0.5, 0, 1>] [0.666015625 rgb <0, 0.5, 1>] [0.669921875 rgb <0.5, 0, 0>] [0.673828125 rgb <0, 0.5, 0>] [0.677734375 rgb <0.5, 0, 0>] [0.681640625 rgb <1, 1, 0.5>] [0.685546875 rgb <0.5, 0, 1>]
  [0.689453125 rgb <0, 1, 0.5>] [0.693359375 rgb <1, 0.5, 0>] [0.697265625 rgb <0, 0.5, 0>] [0.701171875 rgb <0.5, 0, 1>] [0.705078125 rgb <0, 0, 0.5>] [0.708984375 rgb <1, 0, 0.5>] [0.712890625 rgb <1, 1, 0.5>] [0.716796875 rgb <0, 1, 0.5>]
  [0.720703125 rgb <0.5, 0, 0>] [0.724609375 rgb <0, 1, 0.5>] [0.728515625 rgb <1, 1, 0.5>] [0.732421875 rgb <0.5, 1, 1>] [0.736328125 rgb <1, 0, 0.5>] [0.740234375 rgb <0.5, 0, 1>] [0.744140625 rgb <1, 1, 0.5>] [0.748046875 rgb <0.5, 1, 1>]
  [0.751953125 rgb <0.5, 1, 0>] [0.755859375 rgb <1, 0.5, 0>] [0.759765625 rgb <0, 1, 0.5>] [0.763671875 rgb <1, 0.5, 1>] [0.767578125 rgb <0.5, 0, 0>] [0.771484375 rgb <1, 0, 0.5>] [0.775390625 rgb <1, 0, 0.5>] [0.779296875 rgb <0, 1, 0.5>]
  [0.783203125 rgb <0, 1, 0.5>] [0.787109375 rgb <1, 0, 0.5>] [0.791015625 rgb <1, 1, 0.5>] [0.794921875 rgb <1, 1, 0.5>] [0.798828125 rgb <0.5, 0, 0>] [0.802734375 rgb <0, 0, 0.5>] [0.806640625 rgb <1, 0, 0.5>] [0.810546875 rgb <0, 1, 0.5>]
  [0.814453125 rgb <0, 1, 0.5>] [0.818359375 rgb <0, 0, 0.5>] [0.822265625 rgb <0, 1, 0.5>] [0.826171875 rgb <0.5, 0, 0>] [0.830078125 rgb <0.5, 0, 1>] [0.833984375 rgb <0, 1, 0.5>] [0.837890625 rgb <0.5, 0, 0>] [0.841796875 rgb <0.5, 0, 0>]
  [0.845703125 rgb <0, 1, 0.5>] [0.849609375 rgb <1, 1, 0.5>] [0.853515625 rgb <1, 0.5, 0>] [0.857421875 rgb <0.5, 0, 0>] [0.861328125 rgb <0, 0.5, 1>] [0.865234375 rgb <0, 0.5, 0>] [0.869140625 rgb <0.5, 1, 0>] [0.873046875 rgb <0.5, 0, 1>]
  [0.876953125 rgb <0.5, 1, 1>] [0.880859375 rgb <1, 0.5, 1>] [0.884765625 rgb <1, 1, 0.5>] [0.888671875 rgb <1, 1, 0.5>] [0.892578125 rgb <0, 0, 0.5>] [0.896484375 rgb <0.5, 0, 1>] [0.900390625 rgb <1, 0, 0.5>] [0.904296875 rgb <0.5, 0, 1>]
  [0.908203125 rgb <0.5, 0, 0>] [0.912109375 rgb <1, 0.5, 1>] [0.916015625 rgb <1, 0.5, 0>] [0.919921875 rgb <0, 1, 0.5>] [0.923828125 rgb <0.5, 1, 0>] [0.927734375 rgb <1, 1, 0.5>] [0.931640625 rgb <0.5, 0, 1>] [0.935546875 rgb <0.5, 0, 1>]
  [0.939453125 rgb <0, 1, 0.5>] [0.943359375 rgb <1, 0, 0.5>] [0.947265625 rgb <0, 0, 0.5>] [0.951171875 rgb <0.5, 0, 1>] [0.955078125 rgb <0.5, 1, 1>] [0.958984375 rgb <0.5, 1, 1>] [0.962890625 rgb <0, 0, 0.5>] [0.966796875 rgb <0.5, 0, 1>]
  [0.970703125 rgb <1, 1, 0.5>] [0.974609375 rgb <0, 0, 0.5>] [0.978515625 rgb <0, 1, 0.5>] [0.982421875 rgb <1, 0, 0.5>] [0.986328125 rgb <0, 0.5, 0>] [0.990234375 rgb <0.5, 0, 1>] [0.994140625 rgb <1, 1, 0.5>] [0.998046875 rgb <1, 0.5, 1>] } } }
#declare Entry = function(x) { (x + 0.5) / 256 - floor((x + 0.5) / 256) }
#declare Permuted = function(x) { floor(PermutedTable(Entry(x), 0, 0).red * 255 + 0.5) }
#declare GradientX = function(x) { floor(GradientTable(Entry(x), 0, 0).red * 2 + 0.5) - 1 }
#declare GradientY = function(x) { floor(GradientTable(Entry(x), 0, 0).green * 2 + 0.5) - 1 }
#declare GradientZ = function(x) { floor(GradientTable(Entry(x), 0, 0).blue * 2 + 0.5) - 1 }
#declare Corner = function(h, x, y, z) { GradientX(h) * x + GradientY(h) * y + GradientZ(h) * z }
#declare Fade = function(x) { x * x * x * (x * (x * 6 - 15) + 10) }
#declare Mix = function(f, a, b) { a + f * (b - a) }
#declare MixAll = function(aa, ba, ab, bb, ca, da, cb, db, fu, fv, fw) {
  Mix(fw, Mix(fv, Mix(fu, aa, ba), Mix(fu, ab, bb)), Mix(fv, Mix(fu, ca, da), Mix(fu, cb, db))) }
#declare NoiseH = function(aa, ab, ba, bb, fu, fv, fw, x, y, z) {
  MixAll(Corner(aa, x, y, z), Corner(ba, x - 1, y, z), Corner(ab, x, y - 1, z), Corner(bb, x - 1, y - 1, z),
    Corner(aa + 1, x, y, z - 1), Corner(ba + 1, x - 1, y, z - 1), Corner(ab + 1, x, y - 1, z - 1),
    Corner(bb + 1, x - 1, y - 1, z - 1), fu, fv, fw) }
#declare NoiseA = function(a, b, i, x, y, z) {
  NoiseH(Permuted(a) + i, Permuted(a + 1) + i, Permuted(b) + i, Permuted(b + 1) + i, Fade(x), Fade(y),
    Fade(z), x, y, z) }
#declare NoiseI = function(i, j, k, x, y, z) {
  NoiseA(Permuted(i) + j, Permuted(i + 1) + j, k, x - i, y - j, z - k) }
#declare Noise = function(x, y, z) { NoiseI(floor(x), floor(y), floor(z), x, y, z) }

#declare Rise = function(x) { 30 * x * x * (x - 1) * (x - 1) }
#declare SlopeW = function(aa, ba, ab, bb, ca, da, cb, db, fu, fv, fw, x, y, z, ax, ay, az) {
  ax * Rise(x) * Mix(fw, Mix(fv, ba - aa, bb - ab), Mix(fv, da - ca, db - cb)) +
  ay * Rise(y) * Mix(fw, Mix(fu, ab - aa, bb - ba), Mix(fu, cb - ca, db - da)) +
  az * Rise(z) * Mix(fv, Mix(fu, ca - aa, da - ba), Mix(fu, cb - ab, db - bb)) }
#declare SlopeH = function(aa, ab, ba, bb, fu, fv, fw, x, y, z, ax, ay, az) {
  MixAll(Corner(aa, ax, ay, az), Corner(ba, ax, ay, az), Corner(ab, ax, ay, az), Corner(bb, ax, ay, az),
    Corner(aa + 1, ax, ay, az), Corner(ba + 1, ax, ay, az), Corner(ab + 1, ax, ay, az),
    Corner(bb + 1, ax, ay, az), fu, fv, fw) +
  SlopeW(Corner(aa, x, y, z), Corner(ba, x - 1, y, z), Corner(ab, x, y - 1, z), Corner(bb, x - 1, y - 1, z),
    Corner(aa + 1, x, y, z - 1), Corner(ba + 1, x - 1, y, z - 1), Corner(ab + 1, x, y - 1, z - 1),
    Corner(bb + 1, x - 1, y - 1, z - 1), fu, fv, fw, x, y, z, ax, ay, az) }
#declare SlopeA = function(a, b, i, x, y, z, ax, ay, az) {
  SlopeH(Permuted(a) + i, Permuted(a + 1) + i, Permuted(b) + i, Permuted(b + 1) + i, Fade(x), Fade(y),
    Fade(z), x, y, z, ax, ay, az) }
#declare SlopeI = function(i, j, k, x, y, z, ax, ay, az) {
  SlopeA(Permuted(i) + j, Permuted(i + 1) + j, k, x - i, y - j, z - k, ax, ay, az) }
#declare NoiseSlope = function(x, y, z, ax, ay, az) {
  SlopeI(floor(x), floor(y), floor(z), x, y, z, ax, ay, az) }

#declare Dot = function(ax, ay, az, bx, by, bz) { ax * bx + ay * by + az * bz }
#declare Long = function(x, y, z) { sqrt(x * x + y * y + z * z) }
#declare BumpX = function(x, y, z, gx, gy, gz, ax, ay, az) {
  Dot(x, y, z, ax, ay, az) / Long(x, y, z) - Dot(gx, gy, gz, ax, ay, az) }
#declare BumpW = function(mx, my, mz, gx, gy, gz, ax, ay, az, f) {
  BumpX(mx + f * (gx - mx), my + f * (gy - my), mz + f * (gz - mz), gx, gy, gz, ax, ay, az) }
#declare BumpRoot = function(a, b, c) { select(c, -2 * c / (b + sqrt(max(b * b - 4 * a * c, 0))), 0) }
#declare BumpV = function(mx, my, mz, gx, gy, gz, ax, ay, az, mv, mg, gv) {
  BumpW(mx, my, mz, gx, gy, gz, ax, ay, az,
    BumpRoot(2 * (1 - mg) * (gv - mv - 1.015625 * gv),
      2 * (mv * (1 - mg) + (gv - mv) * mg + 1.015625 * gv * (1 - mg)), 2 * mv * mg - 1.015625 * gv)) }
#declare BumpU = function(mx, my, mz, gx, gy, gz, vx, vy, vz, ax, ay, az) {
  BumpV(mx, my, mz, gx, gy, gz, ax, ay, az, Dot(mx, my, mz, vx, vy, vz), Dot(mx, my, mz, gx, gy, gz),
    Dot(gx, gy, gz, vx, vy, vz)) }
#declare BumpT = function(mx, my, mz, gx, gy, gz, vx, vy, vz, ax, ay, az, l) {
  BumpU(mx / l, my / l, mz / l, gx, gy, gz, vx, vy, vz, ax, ay, az) }
#declare BumpR = function(mx, my, mz, gx, gy, gz, vx, vy, vz, ax, ay, az) {
  BumpT(mx, my, mz, gx, gy, gz, vx, vy, vz, ax, ay, az, Long(mx, my, mz)) }
#declare BumpS = function(sx, sy, sz, gx, gy, gz, vx, vy, vz, ax, ay, az, k) {
  BumpR(gx - sx + k * gx, gy - sy + k * gy, gz - sz + k * gz, gx, gy, gz, vx, vy, vz, ax, ay, az) }
#declare Bump = function(sx, sy, sz, gx, gy, gz, vx, vy, vz, ax, ay, az) {
  BumpS(sx, sy, sz, gx, gy, gz, vx, vy, vz, ax, ay, az, Dot(sx, sy, sz, gx, gy, gz)) }

#declare CornerX = function(x, y, z) { select(y - 65536, select(x - 65536, -0.471404521, 0.942809041), 0) }
#declare CornerY = function(x, y, z) { select(y - 65536, -0.333333333, 1) }
#declare CornerZ = function(x, y, z) { select(y - 65536, select(x - 65536, select(z, -0.816496581, 0.816496581), 0), 0) }

#declare OwnX0 = function { 1 * x + 0 * y + 0 * z + 0 }
#declare OwnY0 = function { 0 * x + 1 * y + 0 * z + 0 }
#declare OwnZ0 = function { 0 * x + 0 * y + -1 * z + 0 }
#declare AlongXOwn0 = function(x, y, z) { 0 }
#declare AlongX0 = function(x, y, z) { AlongXOwn0(OwnX0(x, y, z), OwnY0(x, y, z), OwnZ0(x, y, z)) }
#declare AlongYOwn0 = function(x, y, z) { 1 }
#declare AlongY0 = function(x, y, z) { AlongYOwn0(OwnX0(x, y, z), OwnY0(x, y, z), OwnZ0(x, y, z)) }
#declare AlongZOwn0 = function(x, y, z) { 0 }
#declare AlongZ0 = function(x, y, z) { AlongZOwn0(OwnX0(x, y, z), OwnY0(x, y, z), OwnZ0(x, y, z)) }
#declare AcrossX0 = function(x, y, z) { 1 * AlongX0(x, y, z) + 0 * AlongY0(x, y, z) + 0 * AlongZ0(x, y, z) }
#declare AcrossY0 = function(x, y, z) { 0 * AlongX0(x, y, z) + 1 * AlongY0(x, y, z) + 0 * AlongZ0(x, y, z) }
#declare AcrossZ0 = function(x, y, z) { 0 * AlongX0(x, y, z) + 0 * AlongY0(x, y, z) + -1 * AlongZ0(x, y, z) }
#declare OutLength0 = function(x, y, z) { sqrt(pow(AcrossX0(x, y, z), 2) + pow(AcrossY0(x, y, z), 2) + pow(AcrossZ0(x, y, z), 2)) }
#declare OutX0 = function(x, y, z) { AcrossX0(x, y, z) / OutLength0(x, y, z) }
#declare OutY0 = function(x, y, z) { AcrossY0(x, y, z) / OutLength0(x, y, z) }
#declare OutZ0 = function(x, y, z) { AcrossZ0(x, y, z) / OutLength0(x, y, z) }
#declare Bump0 = function(x, y, z, ax, ay, az) { Bump(0.05714285714285715 * NoiseSlope(x / 0.35, y / 0.35, z / 0.35, 1, 0, 0), 0.05714285714285715 * NoiseSlope(x / 0.35, y / 0.35, z / 0.35, 0, 1, 0), 0.05714285714285715 * NoiseSlope(x / 0.35, y / 0.35, z / 0.35, 0, 0, 1), OutX0(x, y, z), OutY0(x, y, z), OutZ0(x, y, z), (0 - x) / Long((0 - x), (2.6 - y), (7 - z)), (2.6 - y) / Long((0 - x), (2.6 - y), (7 - z)), (7 - z) / Long((0 - x), (2.6 - y), (7 - z)), ax, ay, az) }
#declare BumpFrom0 = function(x, y, z, ax, ay, az) { Bump0(x - 131072 * ax, y - 131072 * ay, z - 131072 * az, ax, ay, az) }
#declare Object0 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.5, 0.5, 0.52> transmit 0.5 } normal { function { 0.5 + 0.1875 * BumpFrom0(x, y, z, CornerX(x, y, z), CornerY(x, y, z), CornerZ(x, y, z)) } -5242880 accuracy 131072 } finish { ambient 0 diffuse 2 } }

#declare OwnX1 = function { 1.1764705882352942 * x + 0 * y + 0 * z + 2 }
#declare OwnY1 = function { 0 * x + 1.1764705882352942 * y + 0 * z + -1.011764705882353 }
#declare OwnZ1 = function { 0 * x + 0 * y + 1.1764705882352942 * z + 0 }
#declare AlongXOwn1 = function(x, y, z) { x }
#declare AlongX1 = function(x, y, z) { AlongXOwn1(OwnX1(x, y, z), OwnY1(x, y, z), OwnZ1(x, y, z)) }
#declare AlongYOwn1 = function(x, y, z) { y }
#declare AlongY1 = function(x, y, z) { AlongYOwn1(OwnX1(x, y, z), OwnY1(x, y, z), OwnZ1(x, y, z)) }
#declare AlongZOwn1 = function(x, y, z) { z }
#declare AlongZ1 = function(x, y, z) { AlongZOwn1(OwnX1(x, y, z), OwnY1(x, y, z), OwnZ1(x, y, z)) }
#declare AcrossX1 = function(x, y, z) { 1.1764705882352942 * AlongX1(x, y, z) + 0 * AlongY1(x, y, z) + 0 * AlongZ1(x, y, z) }
#declare AcrossY1 = function(x, y, z) { 0 * AlongX1(x, y, z) + 1.1764705882352942 * AlongY1(x, y, z) + 0 * AlongZ1(x, y, z) }
#declare AcrossZ1 = function(x, y, z) { 0 * AlongX1(x, y, z) + 0 * AlongY1(x, y, z) + 1.1764705882352942 * AlongZ1(x, y, z) }
#declare OutLength1 = function(x, y, z) { sqrt(pow(AcrossX1(x, y, z), 2) + pow(AcrossY1(x, y, z), 2) + pow(AcrossZ1(x, y, z), 2)) }
#declare OutX1 = function(x, y, z) { AcrossX1(x, y, z) / OutLength1(x, y, z) }
#declare OutY1 = function(x, y, z) { AcrossY1(x, y, z) / OutLength1(x, y, z) }
#declare OutZ1 = function(x, y, z) { AcrossZ1(x, y, z) / OutLength1(x, y, z) }
#declare Bump1 = function(x, y, z, ax, ay, az) { Bump(0.2 * NoiseSlope(x / 0.06, y / 0.06, z / 0.06, 1, 0, 0), 0.2 * NoiseSlope(x / 0.06, y / 0.06, z / 0.06, 0, 1, 0), 0.2 * NoiseSlope(x / 0.06, y / 0.06, z / 0.06, 0, 0, 1), OutX1(x, y, z), OutY1(x, y, z), OutZ1(x, y, z), (0 - x) / Long((0 - x), (2.6 - y), (7 - z)), (2.6 - y) / Long((0 - x), (2.6 - y), (7 - z)), (7 - z) / Long((0 - x), (2.6 - y), (7 - z)), ax, ay, az) }
#declare BumpFrom1 = function(x, y, z, ax, ay, az) { Bump1(x - 131072 * ax, y - 131072 * ay, z - 131072 * az, ax, ay, az) }
#declare Object1 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.85, 0.45, 0.1> transmit 0.5 } normal { function { 0.5 + 0.1875 * BumpFrom1(x, y, z, CornerX(x, y, z), CornerY(x, y, z), CornerZ(x, y, z)) } -5242880 accuracy 131072 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.025 } }

#declare OwnX2 = function { 1 * x + 0 * y + 0 * z + -0.10000000000000002 }
#declare OwnY2 = function { 0 * x + 0.7751937984496124 * y + 0 * z + -0.007751937984496125 }
#declare OwnZ2 = function { 0 * x + 0 * y + 1.0000000000000002 * z + -0.10000000000000002 }
#declare AlongXOwn2 = function(x, y, z) { select(y - 1e-7, 0, select(y - 1 + 1e-7, x, 0)) }
#declare AlongX2 = function(x, y, z) { AlongXOwn2(OwnX2(x, y, z), OwnY2(x, y, z), OwnZ2(x, y, z)) }
#declare AlongYOwn2 = function(x, y, z) { select(y - 1e-7, -1, select(y - 1 + 1e-7, -(0) * (0.6 + 0 * y), 1)) }
#declare AlongY2 = function(x, y, z) { AlongYOwn2(OwnX2(x, y, z), OwnY2(x, y, z), OwnZ2(x, y, z)) }
#declare AlongZOwn2 = function(x, y, z) { select(y - 1e-7, 0, select(y - 1 + 1e-7, z, 0)) }
#declare AlongZ2 = function(x, y, z) { AlongZOwn2(OwnX2(x, y, z), OwnY2(x, y, z), OwnZ2(x, y, z)) }
#declare AcrossX2 = function(x, y, z) { 1 * AlongX2(x, y, z) + 0 * AlongY2(x, y, z) + 0 * AlongZ2(x, y, z) }
#declare AcrossY2 = function(x, y, z) { 0 * AlongX2(x, y, z) + 0.7751937984496124 * AlongY2(x, y, z) + 0 * AlongZ2(x, y, z) }
#declare AcrossZ2 = function(x, y, z) { 0 * AlongX2(x, y, z) + 0 * AlongY2(x, y, z) + 1.0000000000000002 * AlongZ2(x, y, z) }
#declare OutLength2 = function(x, y, z) { sqrt(pow(AcrossX2(x, y, z), 2) + pow(AcrossY2(x, y, z), 2) + pow(AcrossZ2(x, y, z), 2)) }
#declare OutX2 = function(x, y, z) { AcrossX2(x, y, z) / OutLength2(x, y, z) }
#declare OutY2 = function(x, y, z) { AcrossY2(x, y, z) / OutLength2(x, y, z) }
#declare OutZ2 = function(x, y, z) { AcrossZ2(x, y, z) / OutLength2(x, y, z) }
#declare Bump2 = function(x, y, z, ax, ay, az) { Bump(0.24 * NoiseSlope(x / 0.25, y / 0.25, z / 0.25, 1, 0, 0), 0.24 * NoiseSlope(x / 0.25, y / 0.25, z / 0.25, 0, 1, 0), 0.24 * NoiseSlope(x / 0.25, y / 0.25, z / 0.25, 0, 0, 1), OutX2(x, y, z), OutY2(x, y, z), OutZ2(x, y, z), (0 - x) / Long((0 - x), (2.6 - y), (7 - z)), (2.6 - y) / Long((0 - x), (2.6 - y), (7 - z)), (7 - z) / Long((0 - x), (2.6 - y), (7 - z)), ax, ay, az) }
#declare BumpFrom2 = function(x, y, z, ax, ay, az) { Bump2(x - 131072 * ax, y - 131072 * ay, z - 131072 * az, ax, ay, az) }
#declare Object2 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.35, 0.45, 0.6> transmit 0.5 } normal { function { 0.5 + 0.1875 * BumpFrom2(x, y, z, CornerX(x, y, z), CornerY(x, y, z), CornerZ(x, y, z)) } -5242880 accuracy 131072 } finish { ambient 0 diffuse 2 reflection { rgb 0.12 } specular 0.12 roughness 0.025 } }

#declare OwnX3 = function { 1.1764705882352942 * x + 0 * y + 0 * z + -2.1176470588235294 }
#declare OwnY3 = function { 0 * x + 1.1764705882352942 * y + 0 * z + -1.011764705882353 }
#declare OwnZ3 = function { 0 * x + 0 * y + 1.1764705882352942 * z + -0.11764705882352944 }
#declare AlongXOwn3 = function(x, y, z) { x }
#declare AlongX3 = function(x, y, z) { AlongXOwn3(OwnX3(x, y, z), OwnY3(x, y, z), OwnZ3(x, y, z)) }
#declare AlongYOwn3 = function(x, y, z) { y }
#declare AlongY3 = function(x, y, z) { AlongYOwn3(OwnX3(x, y, z), OwnY3(x, y, z), OwnZ3(x, y, z)) }
#declare AlongZOwn3 = function(x, y, z) { z }
#declare AlongZ3 = function(x, y, z) { AlongZOwn3(OwnX3(x, y, z), OwnY3(x, y, z), OwnZ3(x, y, z)) }
#declare AcrossX3 = function(x, y, z) { 1.1764705882352942 * AlongX3(x, y, z) + 0 * AlongY3(x, y, z) + 0 * AlongZ3(x, y, z) }
#declare AcrossY3 = function(x, y, z) { 0 * AlongX3(x, y, z) + 1.1764705882352942 * AlongY3(x, y, z) + 0 * AlongZ3(x, y, z) }
#declare AcrossZ3 = function(x, y, z) { 0 * AlongX3(x, y, z) + 0 * AlongY3(x, y, z) + 1.1764705882352942 * AlongZ3(x, y, z) }
#declare OutLength3 = function(x, y, z) { sqrt(pow(AcrossX3(x, y, z), 2) + pow(AcrossY3(x, y, z), 2) + pow(AcrossZ3(x, y, z), 2)) }
#declare OutX3 = function(x, y, z) { AcrossX3(x, y, z) / OutLength3(x, y, z) }
#declare OutY3 = function(x, y, z) { AcrossY3(x, y, z) / OutLength3(x, y, z) }
#declare OutZ3 = function(x, y, z) { AcrossZ3(x, y, z) / OutLength3(x, y, z) }
#declare Bump3 = function(x, y, z, ax, ay, az) { Bump(0.125 * NoiseSlope(x / 0.12, y / 0.12, z / 0.12, 1, 0, 0), 0.125 * NoiseSlope(x / 0.12, y / 0.12, z / 0.12, 0, 1, 0), 0.125 * NoiseSlope(x / 0.12, y / 0.12, z / 0.12, 0, 0, 1), OutX3(x, y, z), OutY3(x, y, z), OutZ3(x, y, z), (0 - x) / Long((0 - x), (2.6 - y), (7 - z)), (2.6 - y) / Long((0 - x), (2.6 - y), (7 - z)), (7 - z) / Long((0 - x), (2.6 - y), (7 - z)), ax, ay, az) }
#declare BumpFrom3 = function(x, y, z, ax, ay, az) { Bump3(x - 131072 * ax, y - 131072 * ay, z - 131072 * az, ax, ay, az) }
#declare Object3 =
  texture { pigment { rgb 0.08 } finish { ambient 0 diffuse 0 emission 2 } }
  texture { pigment { rgb <0.12, 0.3, 0.2> transmit 0.5 } normal { function { 0.5 + 0.1875 * BumpFrom3(x, y, z, CornerX(x, y, z), CornerY(x, y, z), CornerZ(x, y, z)) } -5242880 accuracy 131072 } finish { ambient 0 diffuse 2 reflection { rgb 0.5 } specular 0.5 roughness 0.006666666666666667 } }

plane { <0, 1, 0>, 0 texture { Object0 } }
sphere { <-1.7, 0.86, 0>, 0.85 texture { Object1 } }
cylinder { <0.1, 0.01, 0.1>, <0.1, 1.3, 0.1>, 0.6 texture { Object2 } }
sphere { <1.8, 0.86, 0.1>, 0.85 texture { Object3 } }
