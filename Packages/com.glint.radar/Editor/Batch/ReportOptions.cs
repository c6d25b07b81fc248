using System;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>The options of <c>glint report</c>.</summary>
    public static class ReportOptions
    {
        /// <summary>Value of <see cref="Pose"/> for no pose.</summary>
        public const int NoPose = -1;

        const string Group = "Report";

        static readonly Interval s_poses = Interval.Closed(1, int.MaxValue);

        /// <summary>The report's file; null when not given.</summary>
        public static readonly Option<string> Out = Options.Text("out", "FILE", Group,
            "The file to write, in an existing folder. Without it: report.html in the folder of the results.");

        /// <summary>
        /// Row of the pose shown, from 1; 0 when not given: the strongest; <see cref="NoPose"/>: none.
        /// </summary>
        public static readonly Option<int> Pose = new Option<int>("pose", "N|none", ReadPose)
        {
            Choices = new[] { "none" },
            Group = Group,
            Help = "The pose shown in 3-D and as the radar's picture: its row in results.csv, from 1; of cross "
                + "sections the row of rcs.csv, of range profiles the direction, that the report opens with. "
                + "Without it: the one with the largest amplitude. With none the scene is not opened and no GPU is needed."
        };

        static int ReadPose(string text)
        {
            if (text == "none")
                return NoPose;
            try
            {
                return Values.Whole(text, s_poses);
            }
            catch (FormatException error)
            {
                throw new FormatException(error.Message + ", or none", error);
            }
        }
    }
}
