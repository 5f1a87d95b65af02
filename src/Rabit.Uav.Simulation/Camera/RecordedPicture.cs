using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>A picture on its way to a folder. The holder owns its buffer. A plain value.</summary>
internal struct RecordedPicture : IDisposable
{
    public CameraFrame Frame { get; set; }

    public DateTimeOffset FrameStartUtc { get; set; }

    public readonly void Dispose() => Frame.Dispose();
}
