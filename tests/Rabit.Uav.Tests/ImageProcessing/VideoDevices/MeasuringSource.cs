using System;
using Rabit.Core;
using Rabit.Tests.Shared;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.ImageProcessing.VideoDevices;

/// <summary>
/// Measures what reading a picture allocates on the reader's thread. A collection adds to single ones; what reading
/// itself allocates, each has.
/// </summary>
internal sealed class MeasuringSource(V4l2Camera camera) : IReaderSource<CameraFrame>
{
    private int _read;

    public bool Blocks => camera.Blocks;

    public long MinAllocated { get; private set; } = long.MaxValue;

    public void Open(ReaderContext context) => camera.Open(context);

    public ReaderStep Read(out CameraFrame value)
    {
        long before = Allocated.SoFar;
        ReaderStep step = camera.Read(out value);
        if (step.Kind == ReaderStepKind.Value && ++_read > 3)
            MinAllocated = Math.Min(MinAllocated, Allocated.SoFar - before);
        return step;
    }

    public void Unblock() => camera.Unblock();

    public void Close() => camera.Close();
}
