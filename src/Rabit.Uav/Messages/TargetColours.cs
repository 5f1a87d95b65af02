using System;

namespace Rabit.Uav.Messages;

/// <summary>The colours of targets, as a set: a target has one of them, a mission may be interested in several.</summary>
[Flags]
public enum TargetColours
{
    /// <summary>None.</summary>
    None = 0,

    /// <summary>Red, nominally sRGB 205,28,32.</summary>
    Red = 1,

    /// <summary>Orange, nominally sRGB 242,112,18.</summary>
    Orange = 2,

    /// <summary>Blue, nominally sRGB 28,72,205.</summary>
    Blue = 4,

    /// <summary>Yellow, nominally sRGB 243,214,28.</summary>
    Yellow = 8,

    /// <summary>Magenta, nominally sRGB 212,36,150.</summary>
    Magenta = 16,

    /// <summary>All of them.</summary>
    All = Red | Orange | Blue | Yellow | Magenta,
}
