using System;
using System.IO;
using Rabit.Geodesy.Tests;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Quality;

/// <summary>
/// A test that needs the recorded sets of pictures, which are not part of the repository, and is skipped without them.
/// </summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class PictureSetTheoryAttribute : TheoryAttribute
{
    public PictureSetTheoryAttribute()
    {
        if (Vectors.FolderOf(Path.Combine("imagery", "stills_640")) is null)
            Skip = "The sets of pictures are not there: they are looked for in ../shared/vectors/imagery beside the "
                + "repository, or in imagery of the folder that RABIT_VECTORS names.";
    }
}
