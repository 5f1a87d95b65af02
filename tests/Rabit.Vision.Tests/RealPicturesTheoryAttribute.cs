using System;
using Xunit;

namespace Rabit.Vision.Tests;

/// <summary>A theory on real pictures, which is skipped where they are not.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class RealPicturesTheoryAttribute : TheoryAttribute
{
    public RealPicturesTheoryAttribute(string folder) => Skip = new RealPicturesFactAttribute(folder).Skip;
}
