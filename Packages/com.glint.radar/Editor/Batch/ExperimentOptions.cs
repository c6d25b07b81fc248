using Glint.Core;

namespace Glint.Editor
{
    /// <summary>The options of <c>glint experiments</c>.</summary>
    public static class ExperimentOptions
    {
        const string Group = "Experiments";

        /// <summary>Folder for tables, plots and figures; null when not given.</summary>
        public static readonly Option<string> Out = new Option<string>("out", "DIR", Values.NotEmpty)
        {
            Group = Group,
            Help = "Folder for experiments.md, experiments.json and the plots in images/, "
                + "made with its parents when it is not there."
        };

        /// <summary>Seas with the same wind and choppiness.</summary>
        public static readonly Option<int> Seeds = Options.Whole("seeds", "N", "20", Interval.Closed(1, 1000), Group,
            "Seas of each wind and choppiness: the stored one, "
                + "and others that differ from it in nothing but the seed.");
    }
}
