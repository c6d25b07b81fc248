using System;
using System.Globalization;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>The options of <c>glint ppi</c>.</summary>
    public static class ScreenOptions
    {
        const string Group = "Radar screen", VideoGroup = "Radar video (ASTERIX category 240)";

        static readonly Interval s_ports = Interval.Closed(1, 65535);

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
            "Folder for picture.png and video.npz, created with its parents if missing.");

        /// <summary>File of radar video; null when not given.</summary>
        public static readonly Option<string> Asterix = Options.Text("asterix", "FILE", VideoGroup,
            "Also write the video of all turns to a file, a message a spoke.");

        /// <summary>Where radar video is sent; null when not given.</summary>
        public static readonly Option<UdpTarget> Udp = new Option<UdpTarget>("udp", "[HOST:]PORT", UdpTarget.Parse)
        {
            Group = VideoGroup,
            Range = "port " + s_ports,
            Help = "Also send the video by UDP, a datagram a spoke, to a port of a host or of a multicast group, such as "
                + "239.192.43.78:4378. Without a host: 127.0.0.1. The files are written as fast as the device allows; "
                + "with this option frames keep to the clock."
        };

        /// <summary>Networks that multicast may pass.</summary>
        public static readonly Option<int> Ttl = new Option<int>("ttl", "N", text => Values.Whole(text,
            Interval.Closed(0, 255)))
        {
            Group = VideoGroup, Range = Interval.Closed(0, 255).ToString(), DefaultText = "1",
            Needs = new Option[] { Udp }, Help = "Networks that a multicast datagram may pass; 1 is the local one."
        };

        /// <summary>All options, in the order of the help.</summary>
        public static readonly Option[] All = { Turns, FrameRate, Time, Out, Asterix, Udp, Ttl, Options.Device };

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
                    CultureInfo.InvariantCulture, out int port) || !s_ports.Contains(port))
                    throw new FormatException($"give a port {s_ports}, or host and port as in 239.192.43.78:4378");
                return new UdpTarget(host, port);
            }
        }
    }
}
