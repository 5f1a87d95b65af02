using System;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>A manager that takes the pictures of a camera: calls back with each, its pixels and the time.</summary>
internal sealed class FrameTaker : RabitManager
{
    private readonly Action<CameraFrame, byte[], TimeSpan> _take;
    private readonly BlockingReader<CameraFrame> _reader;

    public FrameTaker(IReaderSource<CameraFrame> camera, Action<CameraFrame, byte[], TimeSpan> take)
        : base("taker")
    {
        _take = take;
        _reader = AttachReader("camera", camera, capacity: 10);
    }

    /// <summary>Whether a stop waits for it, to its limit or the next request. Before the start.</summary>
    public bool HoldsUpTheStop
    {
        get => DelaysStop;
        set => DelaysStop = value;
    }

    protected override void ExecuteUnitOfWork()
    {
        while (_reader.TryPop(out CameraFrame frame))
        {
            using (frame)
                _take(frame, frame.Pixels.Span.Slice(0, frame.Width * frame.Height * 3).ToArray(), Now);
        }
    }
}
