using System.Net;
using System.Net.Sockets;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class DatagramSenderTests
    {
        // The longest message is one datagram; only the loopback is used.
        [Test]
        public void Datagrams_ToTheLoopback_ArriveWhole()
        {
            using (var receiver = new UdpClient(new IPEndPoint(IPAddress.Loopback, 0)))
            using (var sender = new DatagramSender(((IPEndPoint)receiver.Client.LocalEndPoint).Port))
            {
                receiver.Client.ReceiveTimeout = 10000;
                var video = new AsterixVideo(1, 2, 7.5);
                foreach (int count in new[] { 3, 65280 })
                {
                    byte[] block = video.Encode(10, 11, 0, new byte[count], 0);
                    sender.Send(block);
                    IPEndPoint from = null;
                    Assert.That(receiver.Receive(ref from), Is.EqualTo(block));
                }
            }
        }

        [Test]
        public void Datagrams_WithoutReceiver_AreSent()
        {
            int port;
            using (var closed = new UdpClient(new IPEndPoint(IPAddress.Loopback, 0)))
                port = ((IPEndPoint)closed.Client.LocalEndPoint).Port;
            using (var sender = new DatagramSender(port))
                for (int i = 0; i < 3; i++)
                    Assert.That(() => sender.Send(new byte[8]), Throws.Nothing);
        }

        [Test]
        public void Datagram_ThatIsTooLong_IsRefused()
        {
            using (var sender = new DatagramSender(4000))
                AssertRefused(() => sender.Send(new byte[70000]),
                    "UDP: the number of bytes of a datagram is 70000, it must be from 1 to 65507");
        }

        [Test]
        public void Sender_WithoutAHost_IsRefused()
        {
            AssertRefused(() => new DatagramSender(0), "UDP: the port is 0, it must be from 1 to 65535");
            AssertRefused(() => new DatagramSender(4000, "239.1.2.3", 256),
                "UDP: the multicast TTL is 256, it must be from 0 to 255");
            AssertRefused(() => new DatagramSender(4000, "::1"),
                "UDP: the host ::1 has no IPv4 address: give another one");
            Assert.That(() => new DatagramSender(4000, "0.0.0.0"), Throws.TypeOf<GlintException>().With.Message
                .StartsWith("UDP: cannot send to 0.0.0.0:4000 (").And.Message.EndsWith("): give another host"));
        }

        static void AssertRefused(TestDelegate call, string message) =>
            Assert.That(call, Throws.TypeOf<GlintException>().With.Message.EqualTo(message));
    }
}
