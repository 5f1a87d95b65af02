using System;
using Xunit;

namespace Rabit.Geodesy.Tests;

/// <summary>
/// A test that needs the whole reference sets, of which the repository has a part, and is skipped without them.
/// </summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class WholeVectorsFactAttribute : FactAttribute
{
    public WholeVectorsFactAttribute()
    {
        if (!Vectors.AreWhole)
            Skip = "Only the part in tests/data/autonomy is tested: the whole sets are looked for in "
                + "../shared/vectors/autonomy beside the repository, or in autonomy of the folder that RABIT_VECTORS "
                + "names.";
    }
}
