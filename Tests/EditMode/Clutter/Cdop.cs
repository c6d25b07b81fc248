using System;

namespace Glint.Tests
{
    /// <summary>
    /// CDOP: Doppler centroid of the sea at C band, fitted to measurements of a satellite's radar (Mouche et al., IEEE
    /// TGRS 50 (2012) 2901; coefficients as in github.com/ACHMartin/seastar_project, seastar/gmfs/doppler.py).
    /// </summary>
    static class Cdop
    {
        // Scale and offset of incidence, wind and azimuth to inputs of the network.
        static readonly double[,] s_inputsVV =
            {
                { 0.028213254683, -0.343935744939 }, { 0.0411764705882, 0.108823529412 }, { 0.00388888888889, 0.15 }
            },
            s_inputsHH =
            {
                { 0.0281843837385, -0.342097701547 }, { 0.0318181818182, 0.118181818182 },
                { 0.00388888888889, 0.15 }
            };

        // Of each of eleven neurons: weights of incidence, wind and azimuth, offset, weight of its output.
        static readonly double[,] s_neuronsVV =
            {
                { 19.7873046673, 22.2237414308, 1.27887019276, 14.5077150927, 7.34881153553 },
                { 2.910815875, -3.63395681095, 16.4242081101, -11.4312028555, 0.487879873912 },
                { 1.03269004609, 0.403986575614, 0.325018607578, 1.28692747109, -22.167664703 },
                { 3.17100261168, 4.47461213024, 0.969975702316, -1.19498666071, 7.01176085914 },
                { -3.80611082432, -6.91334859293, -0.0162650756459, 1.778908726, 3.57021820094 },
                { 4.09854466913, -1.64290475596, -13.4031862615, 11.8880215573, -7.05653415486 },
                { 0.484338480824, -1.30503436654, -6.04613303002, 1.70176062351, -8.82147148713 },
                { -11.1000239122, 15.993470129, 23.2186869807, 24.7941267067, 5.35079872715 },
                { -0.577883159569, 0.801977535733, 6.13874672206, -8.18756617111, 93.627037987 },
                { 0.61008842868, -0.5009830671, -4.42736737765, 1.32555779345, 13.9420969201 },
                { -1.94654022702, 1.31351068862, 8.94943709074, -9.06560116738, -34.4032326496 }
            },
            s_neuronsHH =
            {
                { -2.61087309812, -0.973599180956, -9.07176856257, 1.30653883096, -8.21498722494 },
                { -0.246776181361, 0.586523978839, -0.594867645776, -2.77086154074, -94.9645431048 },
                { 17.9261562541, 12.9439063319, 16.9815377306, 10.6792861882, -17.7727420108 },
                { 0.595882115891, 6.20098098757, -9.20238868219, -4.0429666906, -63.3536337981 },
                { -0.993509213443, 0.301856868548, -4.12397246171, -0.172201666743, 39.2450482271 },
                { 15.0224985357, 17.643307099, 8.57886720397, 20.4895916824, -6.15275352542 },
                { 13.1833641617, 20.6983195925, -15.1439734434, 28.2856865516, 16.5337543167 },
                { 0.656338134446, 5.79854593024, -9.9811757434, -3.60143441597, 90.1967379935 },
                { 0.122736690257, -5.67640781126, 11.9861607453, -3.53935574111, -1.11346786284 },
                { 0.691577162612, 5.95289490539, -16.0530462, -2.11695768022, -17.57689699 },
                { 1.2664066483, 0.151056851685, 7.93435940581, -2.57805898849, 8.20219395141 }
            };

        /// <summary>Hz at 5.33 GHz; above 0 towards the radar.</summary>
        /// <param name="wind">10 m above the sea, m/s.</param>
        /// <param name="azimuth">0: the radar looks against the wind, deg, up to 180.</param>
        /// <param name="incidence">deg.</param>
        public static double Hertz(double wind, double azimuth, double incidence, bool isHorizontal)
        {
            var (inputs, neurons) = isHorizontal ? (s_inputsHH, s_neuronsHH) : (s_inputsVV, s_neuronsVV);
            var values = new[] { incidence, wind, azimuth };
            double sum = isHorizontal ? 2.68352095337 : 4.07777876994;
            for (int i = 0; i < neurons.GetLength(0); i++)
            {
                double input = neurons[i, 3];
                for (int j = 0; j < values.Length; j++)
                    input += neurons[i, j] * (inputs[j, 0] * values[j] + inputs[j, 1]);
                sum += neurons[i, 4] * Sigmoid(input);
            }
            return isHorizontal ? 136.216953823 * Sigmoid(sum) - 66.9554922921
                : 111.528184073 * Sigmoid(sum) - 52.2644487109;
        }

        static double Sigmoid(double x) => 1 / (1 + Math.Exp(-x));
    }
}
