using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>The power that a quadrotor of about 2 kg draws from its battery, W.</summary>
internal static class PowerDraw
{
    // Hovering, against the air, climbing, and by what is always on.
    private const double HoverWatts = 180;
    private const double DragWattsPerCube = 0.05;
    private const double ClimbWattsPerSpeed = 20;
    private const double IdleWatts = 25;
    private const double ElectronicsWatts = 8;

    /// <param name="motors">What the motors do.</param>
    /// <param name="velocity">Over ground.</param>
    /// <param name="wind">Of the air.</param>
    public static double Watts(MotorState motors, NedVector velocity, NedVector wind)
    {
        if (motors == MotorState.Off)
            return ElectronicsWatts;
        if (motors == MotorState.Idle)
            return ElectronicsWatts + IdleWatts;
        double speed = velocity.Minus(wind).HorizontalLength();
        double climb = Math.Max(-0.5 * HoverWatts, -velocity.Down * ClimbWattsPerSpeed);
        return ElectronicsWatts + HoverWatts + (DragWattsPerCube * speed * speed * speed) + climb;
    }
}
