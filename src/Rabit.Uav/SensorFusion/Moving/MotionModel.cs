using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>How targets of a class move: constant velocity under one or two intensities of noise. Immutable.</summary>
internal sealed class MotionModel
{
    private readonly double _quiet;
    private readonly double _lively;

    private MotionModel(double quiet, double lively, double startVelocitySigma, double leaveQuiet, double leaveLively)
    {
        (_quiet, _lively) = (quiet, lively);
        StartVelocitySigma = startVelocitySigma;
        (LeaveQuietPerSecond, LeaveLivelyPerSecond) = (leaveQuiet, leaveLively);
    }

    /// <summary>A person on foot, who may stop and go on.</summary>
    public static MotionModel Walking { get; } = ConstantVelocity(0.1, TargetSpeeds.WalkingMetresPerSecond);

    /// <summary>A vehicle: goes straight on, or turns, brakes or starts with up to 4 m/s2.</summary>
    public static MotionModel Vehicle { get; } = TwoModes(
        0.05, 20, TargetSpeeds.VehicleMetresPerSecond, 0.1, 0.3);

    /// <summary>One or two.</summary>
    public int Modes => _lively > _quiet ? 2 : 1;

    /// <summary>Standard deviation of the velocity with which a track starts, per axis, metres per second.</summary>
    public double StartVelocitySigma { get; }

    /// <summary>How often a target begins to turn, brake or start, per second.</summary>
    public double LeaveQuietPerSecond { get; }

    /// <summary>How often it ends that.</summary>
    public double LeaveLivelyPerSecond { get; }

    /// <summary>A target of one way to move.</summary>
    /// <param name="processNoise">Intensity of its white acceleration, m2/s3.</param>
    /// <param name="startVelocitySigma">Metres per second and axis.</param>
    public static MotionModel ConstantVelocity(double processNoise, double startVelocitySigma)
        => new(processNoise, processNoise, startVelocitySigma, 0, 0);

    /// <summary>A target that goes on straight and, now and then, turns, brakes or starts.</summary>
    /// <param name="quiet">Intensity of the white acceleration while it goes on, m2/s3.</param>
    /// <param name="lively">While it turns; above the other one.</param>
    /// <param name="startVelocitySigma">Metres per second and axis.</param>
    /// <param name="leaveQuietPerSecond">How often it begins to turn.</param>
    /// <param name="leaveLivelyPerSecond">How often it ends that.</param>
    public static MotionModel TwoModes(
        double quiet,
        double lively,
        double startVelocitySigma,
        double leaveQuietPerSecond,
        double leaveLivelyPerSecond)
        => new(quiet, lively, startVelocitySigma, leaveQuietPerSecond, leaveLivelyPerSecond);

    /// <summary>
    /// The same target while it meets another one: it is less likely to turn or stop just there than anywhere.
    /// </summary>
    /// <param name="factor">By which the white acceleration is less.</param>
    public MotionModel Steadier(double factor) => new(
        factor * _quiet, factor * _lively, StartVelocitySigma, LeaveQuietPerSecond, LeaveLivelyPerSecond);

    /// <summary>Intensity of the white acceleration of a mode, m2/s3.</summary>
    public double ProcessNoise(int mode) => mode == 0 ? _quiet : _lively;

    /// <summary>How likely it is in a mode at the end of a time that it was in at the beginning.</summary>
    /// <param name="from">The mode at the beginning.</param>
    /// <param name="to">The mode at the end.</param>
    /// <param name="seconds">The time.</param>
    public double Transition(int from, int to, double seconds)
    {
        // The exact solution of a chain of two states in continuous time.
        double sum = LeaveQuietPerSecond + LeaveLivelyPerSecond;
        double leave = from == 0 ? LeaveQuietPerSecond : LeaveLivelyPerSecond;
        double left = leave / sum * (1 - Math.Exp(-sum * seconds));
        return from == to ? 1 - left : left;
    }
}
