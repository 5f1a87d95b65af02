using System;
using Rabit.Uav.ImageProcessing;

namespace Rabit.Uav.Reporting;

/// <summary>What a camera folder delivered in a run. Immutable.</summary>
public sealed class CameraSummary
{
    /// <summary>Copies the counts of a camera folder.</summary>
    /// <param name="camera">After the run.</param>
    public CameraSummary(FolderCamera camera)
    {
        if (camera is null)
            throw new ArgumentNullException(nameof(camera));
        Delivered = camera.PicturesDelivered;
        BeforeRun = camera.PicturesBeforeRun;
        Late = camera.PicturesLate;
        Ahead = camera.PicturesAhead;
        Refused = camera.PicturesRefused;
        WithoutBuffer = camera.PicturesWithoutBuffer;
        LastRefusal = camera.LastRefusal;
    }

    /// <summary>Pictures that were delivered.</summary>
    public long Delivered { get; }

    /// <summary>Pictures that were not read, since they are older than the run.</summary>
    public long BeforeRun { get; }

    /// <summary>Pictures that were not read, since they came after a later one.</summary>
    public long Late { get; }

    /// <summary>Pictures that were not read, since their time is ahead of the clock.</summary>
    public long Ahead { get; }

    /// <summary>Pictures that were refused: damaged, of another size, or with a name without its time.</summary>
    public long Refused { get; }

    /// <summary>Pictures that were lost, since no buffer was free.</summary>
    public long WithoutBuffer { get; }

    /// <summary>Why the last refused picture was refused; null where none was.</summary>
    public string? LastRefusal { get; }
}
