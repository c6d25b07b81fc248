using System;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint
{
    /// <summary>
    /// Sends the video of the <see cref="RadarScreen"/> on the same object by UDP while the scene plays: ASTERIX
    /// category 240, a datagram a spoke, for chart plotters, trackers and recorders. Nothing is sent without this
    /// component.
    /// </summary>
    [AddComponentMenu("Glint/Radar Video Sender")]
    [HelpPage("screen.md")]
    [RequireComponent(typeof(RadarScreen))]
    [DisallowMultipleComponent]
    public sealed class RadarVideoSender : MonoBehaviour
    {
        [SerializeField, Tooltip("Name or address of a machine or of a multicast group.")]
        string _host = "127.0.0.1";

        [SerializeField, Range(1, 65535), Tooltip("UDP port.")]
        int _port = 4378;

        [SerializeField, Range(0, 255), Tooltip("Networks that a multicast datagram may pass: 1 is the local one.")]
        int _multicastTtl = 1;

        RadarScreen _screen;
        ScreenAsterix _encoder;
        ScreenGeometry _geometry;
        DatagramSender _sender;
        long _sent;                        // first spoke of the last frame sent

        /// <summary>Name or address of a machine or of a multicast group; taken when the component is enabled.</summary>
        public string Host { get => _host; set => _host = value; }

        /// <summary>UDP port, 1 to 65535; taken when the component is enabled.</summary>
        public int Port { get => _port; set => _port = value; }

        /// <summary>Networks that a multicast datagram may pass; taken when the component is enabled.</summary>
        public int MulticastTtl { get => _multicastTtl; set => _multicastTtl = value; }

        void OnEnable()
        {
            _screen = GetComponent<RadarScreen>();
            Attempt(() =>
            {
                if (!SystemInfo.supportsAsyncGPUReadback)
                    throw new GlintException($"{SystemInfo.graphicsDeviceName} has no asynchronous read-back, "
                        + "which video needs: use another device or graphics API");
                _sender = new DatagramSender(_port, _host, _multicastTtl);
            });
        }

        // After the screen's Update.
        void LateUpdate()
        {
            var tracer = _screen.Tracer;
            if (_sender == null || tracer == null || tracer.Slice.Finished == 0)
                return;
            if (_geometry == tracer.Geometry && _sent == tracer.Slice.FirstFinished)
                return;
            _sent = tracer.Slice.FirstFinished;
            if (_geometry != tracer.Geometry)
                (_geometry, _encoder) = (tracer.Geometry, new ScreenAsterix(tracer.Geometry));
            int whole = tracer.FinishedBeforeNorth;
            Request(tracer, tracer.Slice.FirstFinished, whole);
            if (whole < tracer.Slice.Finished)
                Request(tracer, tracer.Slice.FirstFinished + whole, tracer.Slice.Finished - whole);
        }

        void Request(ScreenTracer tracer, long first, int count)
        {
            int bytes = tracer.Video.Stride * _geometry.Radar.Cells,
                inTurn = _geometry.InTurn(first);
            var (sender, encoder, geometry, seconds) = (_sender, _encoder, _geometry, DateTime.UtcNow.TimeOfDay.TotalSeconds);
            AsyncGPUReadback.Request(tracer.Video.Buffer, count * bytes, inTurn * bytes, request =>
            {
                // It may have failed in the meantime, or been enabled again.
                if (!request.hasError && sender == _sender)
                    Attempt(() => Send(encoder, geometry, request.GetData<float2>().ToArray(), first, seconds));
            });
        }

        void Send(ScreenAsterix encoder, ScreenGeometry geometry, float2[] video, long first, double seconds)
        {
            int cells = geometry.Radar.Cells;
            for (int i = 0; i < video.Length / cells; i++)
                _sender.Send(encoder.Encode(first + i, video, i * cells, seconds));
        }

        // A problem is reported once: nothing is sent until the component is enabled again.
        void Attempt(Action action)
        {
            try
            {
                action();
            }
            catch (GlintException problem)
            {
                Close();
                Debug.LogError($"RadarVideoSender of '{name}': {problem.Message}", this);
            }
        }

        void OnDisable() => Close();

        void Close()
        {
            _sender?.Dispose();
            _sender = null;
        }
    }
}
