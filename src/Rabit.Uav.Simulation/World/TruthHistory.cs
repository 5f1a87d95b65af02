using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The true poses of the last seconds: written by the simulated vehicle step by step, read by the simulated camera
/// for moments that have passed. It stands for the physical world between two devices, so it is the one thing here
/// that is shared, under a lock.
/// </summary>
internal sealed class TruthHistory(int capacity)
{
    private readonly object _gate = new();
    private readonly TruePose[] _ring = new TruePose[capacity];   // under _gate
    private long _count;                                          // under _gate

    /// <summary>Adds the newest; times go up.</summary>
    public void Add(in TruePose pose)
    {
        lock (_gate)
        {
            _ring[_count % _ring.Length] = pose;
            _count++;
        }
    }

    /// <summary>
    /// The pose at a time, linearly between two steps; false where it is not known yet or not any more.
    /// </summary>
    public bool TryGet(TimeSpan time, out TruePose pose)
    {
        lock (_gate)
        {
            for (long index = _count - 1; index > 0 && index > _count - _ring.Length; index--)
            {
                ref TruePose before = ref _ring[(index - 1) % _ring.Length];
                ref TruePose after = ref _ring[index % _ring.Length];
                if (before.Time <= time && time <= after.Time)
                {
                    pose = Between(before, after, time);
                    return true;
                }
            }
        }

        pose = default;
        return false;
    }

    private static TruePose Between(in TruePose a, in TruePose b, TimeSpan time)
    {
        double part = b.Time == a.Time ? 0 : (time - a.Time).Ticks / (double)(b.Time - a.Time).Ticks;
        return new TruePose
        {
            Time = time,
            Position = a.Position + (part * (b.Position - a.Position)),
            VelocityNed = a.VelocityNed + (part * (b.VelocityNed - a.VelocityNed)),
            Attitude = new EulerAngles(
                Mix(a.Attitude.Roll, b.Attitude.Roll, part),
                Mix(a.Attitude.Pitch, b.Attitude.Pitch, part),
                Mix(a.Attitude.Yaw, b.Attitude.Yaw, part)),
            CameraFrame = a.CameraFrame,
            CameraPitch = Mix(a.CameraPitch, b.CameraPitch, part),
            CameraRoll = Mix(a.CameraRoll, b.CameraRoll, part),
            CameraYaw = Mix(a.CameraYaw, b.CameraYaw, part),
        };
    }

    private static Angle Mix(Angle a, Angle b, double part) => a + (part * (b - a));
}
