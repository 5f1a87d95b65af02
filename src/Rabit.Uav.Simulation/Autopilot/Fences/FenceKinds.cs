using System;

namespace Rabit.Uav.Simulation;

/// <summary>The parts of a fence, by the bits of FENCE_TYPE.</summary>
[Flags]
internal enum FenceKinds
{
    None = 0,
    MaxHeight = 1,
    Circle = 2,
    Polygon = 4,
}
