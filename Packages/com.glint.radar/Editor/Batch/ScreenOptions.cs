using System;
using System.Globalization;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>The options of <c>glint ppi</c>.</summary>
    public static class ScreenOptions
    {
        const string Group = "Radar screen", VideoGroup = "Radar video (ASTERIX category 240)";

        /// <summary>Turns of the antenna.</summary>
        public static readonly Option<int> Turns = Options.Whole("turns", "N", "2", Interval.Closed(1, 10000), Group,
            "Turns of the antenna. The files have the last one, with what persists of those before.");

        /// <summary>Frames a second.</summary>
        public static readonly Option<int> FrameRate = Options.Whole("fps", "N", "20", Interval.Closed(1, 1000), Group,
            "Frames a second of the scene's time. The radar sees ships and waves as they are in each frame.");

        /// <summary>Seconds before the first turn.</summary>
        public static readonly Option<double> Time = Options.Number("time", "S", "0", Interval.Closed(0, 1e6), Group,
            InputKind.Any, "Seconds for which the scene runs before the first turn.");

        /// <summary>Folder for the files; null when not given.</summary>
        public static readonly Option<string> Out = Options.Text("out", "DIR", "Results",
            "Folder for picture.png, video.npz and results.json, created with its parents if missing.");

        /// <summary>File of radar video; null when not given.</summary>
        public static readonly Option<string> Asterix = Options.Text("asterix", "FILE", VideoGroup,
            "Also write the video of all turns to a file, a message a spoke.");

        /// <summary>Where radar video is sent; null when not given.</summary>
        public static readonly Option<UdpTarget> Udp = new Option<UdpTarget>("udp", "[HOST:]PORT", UdpTarget.Parse)
        {
            Group = VideoGroup,
            Range = "port " + DatagramSender.Ports,
            Help = "Also send the video by UDP, a datagram a spoke, to a port of a host or of a multicast group, such as "
                + "239.192.43.78:4378. Without a host: 127.0.0.1. The files are written as fast as the device allows; "
                + "with this option frames keep to the clock, and a warning says where the device is too slow for that."
        };

        /// <summary>Networks that multicast may pass.</summary>
        public static readonly Option<int> Ttl = Options.Needing(Udp, Options.Whole("ttl", "N", "1",
            DatagramSender.TimesToLive, VideoGroup, "Networks that a multicast datagram may pass; 1 is the local one."));

        /// <summary>How targets are detected; null when not given.</summary>
        public static readonly Option<string> Detect = EchoOptions.NewDetect(
            "the cells of the last turn, along the range of each spoke,", " The picture shows them.");

        /// <summary>False alarms a cell.</summary>
        public static readonly Option<double> FalseAlarm = EchoOptions.NewFalseAlarm(Detect);

        /// <summary>Whether video.csv is written.</summary>
        public static readonly Option<bool> Table = Options.Switch("csv", "Results",
            "Also write video.csv, a line for each cell of the last turn: bearing, range, power and video.");

        /// <summary>All options, in the order of the help.</summary>
        public static readonly Option[] All =
        {
            Turns, FrameRate, Time, Detect, FalseAlarm, Out, Table, Asterix, Udp, Ttl, Options.Device
        };

        /// <summary>A host and a port.</summary>
        public sealed class UdpTarget
        {
            UdpTarget(string host, int port) => (Host, Port) = (host, port);

            /// <summary>Name or address.</summary>
            public string Host { get; }

            /// <summary>1 to 65535.</summary>
            public int Port { get; }

            internal static UdpTarget Parse(string text)
            {
                int colon = text.LastIndexOf(':');
                string host = colon < 0 ? "127.0.0.1" : text.Substring(0, colon);
                if (host.Length == 0 || !int.TryParse(text.Substring(colon + 1), NumberStyles.None,
                    CultureInfo.InvariantCulture, out int port) || !DatagramSender.Ports.Contains(port))
                    throw new FormatException($"give a port {DatagramSender.Ports}, or host and port as in 239.192.43.78:4378");
                return new UdpTarget(host, port);
            }
        }
    }
}
