using System;
using Rabit.Core;

namespace Wheelchair.Devices;

/// <summary>A driver who drives at a wall as fast as he can, lets go, backs away from it, and gets off.</summary>
internal sealed class ScriptedJoystick : PeriodicDevice<double>
{
    protected override ReaderStep Measure(TimeSpan now, out double value)
    {
        double seconds = now.TotalSeconds;
        value = seconds < 0.5 ? 0 : seconds < 7 ? 1 : seconds < 7.5 ? 0 : seconds < 9 ? -0.5 : 0;
        return seconds < 10 ? ReaderStep.Value : ReaderStep.Ended;
    }
}
