using System;
using System.Net;
using System.Net.Sockets;

namespace Glint.Core
{
    /// <summary>Sends datagrams by UDP to one host or multicast group.</summary>
    public sealed class DatagramSender : IDisposable
    {
        /// <summary>UDP ports.</summary>
        public static readonly Interval Ports = Interval.Closed(1, 65535);

        /// <summary>Networks that multicast may pass.</summary>
        public static readonly Interval TimesToLive = Interval.Closed(0, 255);

        // 65,535 without the headers of IPv4 and UDP.
        const int MaxLength = 65507;

        readonly string _target;
        readonly IPEndPoint _endPoint;
        readonly UdpClient _client;

        /// <param name="port">1 to 65535.</param>
        /// <param name="host">Name or address; that of a multicast group sends to all that joined it.</param>
        /// <param name="multicastTtl">Networks that a multicast datagram may pass, 0 to 255: 1 is the local one.</param>
        /// <exception cref="GlintException">
        /// The host is unknown or takes nothing, or a number is out of its range.
        /// </exception>
        public DatagramSender(int port, string host = "127.0.0.1", int multicastTtl = 1)
        {
            Require.Within("UDP", "port", port, "", Ports);
            Require.Within("UDP", "multicast TTL", multicastTtl, "", TimesToLive);
            _target = $"{host}:{port}";
            try
            {
                var address = Array.Find(Dns.GetHostAddresses(host),
                    candidate => candidate.AddressFamily == AddressFamily.InterNetwork)
                    ?? throw new GlintException($"UDP: the host {host} has no IPv4 address: give another one");
                _client = new UdpClient(AddressFamily.InterNetwork);
                _client.Client.SetSocketOption(SocketOptionLevel.IP, SocketOptionName.MulticastTimeToLive,
                    multicastTtl);
                // Not connected: no report that nothing listens yet stops a later datagram.
                _endPoint = new IPEndPoint(address, port);
            }
            // ArgumentException: 0.0.0.0, which only listens, or a name that is too long
            catch (Exception error) when (error is SocketException || error is ArgumentException)
            {
                _client?.Dispose();
                throw new GlintException($"UDP: cannot send to {_target} ({error.Message}): give another host", error);
            }
        }

        /// <summary>Sends one datagram.</summary>
        /// <param name="datagram">At most 65,507 bytes.</param>
        /// <exception cref="GlintException">It is too long, or the system refuses it.</exception>
        public void Send(byte[] datagram)
        {
            Require.Count("UDP", "number of bytes of a datagram", datagram.Length, MaxLength);
            try
            {
                _client.Send(datagram, datagram.Length, _endPoint);
            }
            catch (SocketException error)
            {
                throw new GlintException($"UDP: cannot send {datagram.Length} bytes to {_target} ({error.Message}): "
                    + "give another host", error);
            }
        }

        /// <summary>Closes the socket.</summary>
        public void Dispose() => _client.Dispose();
    }
}
