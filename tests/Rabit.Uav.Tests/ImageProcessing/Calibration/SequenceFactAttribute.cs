using System;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Calibration;

/// <summary>
/// A test that needs the recorded sequence of pictures, which is not part of the repository, and is skipped without it.
/// </summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class SequenceFactAttribute : FactAttribute
{
    public SequenceFactAttribute()
    {
        if (RecordedSequence.Folder is null)
            Skip = "sequence_01 is not there: it is looked for in ../shared/vectors/imagery beside the repository, or "
                + "in imagery of the folder that RABIT_VECTORS names.";
    }
}
