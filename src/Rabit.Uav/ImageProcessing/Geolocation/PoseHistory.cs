using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// Positions and attitudes of the last seconds, from which the pose at a moment is interpolated: attitude by SLERP,
/// position by a cubic through positions and velocities (Hermite). It is extrapolated beyond the newest only where that
/// is asked for. Fixed memory; for one thread.
/// </summary>
internal sealed class PoseHistory(TimeSpan maxGap)
{
    // At 50 attitudes and 10 positions a second some 10 and 25 s; a picture is asked for within half a second.
    private const int AttitudesKept = 512;
    private const int PositionsKept = 256;

    // Samples may come a little out of order, and a link may pause. Two that are further than this from the newest one
    // are of a clock that was set again, or came after a pause; one is nothing.
    private static readonly TimeSpan MaxStep = TimeSpan.FromSeconds(2);

    private readonly TimedRing<PositionSample> _positions = new(PositionsKept, MaxStep);
    private readonly TimedRing<AttitudeSample> _attitudes = new(AttitudesKept, MaxStep);
    private long _invalid;
    private double _timeError;

    /// <summary>
    /// Samples that were not used: not a number, out of range, of a moment that was there already, too old, or with a
    /// time that no other one agrees with.
    /// </summary>
    public long Refused => _invalid + _positions.Refused + _attitudes.Refused;

    /// <summary>How often time jumped back, so that all before was forgotten.</summary>
    public long Restarts => _positions.Restarts + _attitudes.Restarts;

    public void Add(in PoseSample sample)
    {
        if (sample.TimeErrorSeconds >= 0 && sample.TimeErrorSeconds < MaxStep.TotalSeconds)
            _timeError = sample.TimeErrorSeconds;
        if (sample.Kind == PoseSampleKind.Position && IsValid(sample.Position))
            _positions.Add(
                sample.Time, new PositionSample { Position = sample.Position, VelocityNed = sample.VelocityNed });
        else if (sample.Kind == PoseSampleKind.Attitude && sample.Attitude.IsFinite)
            _attitudes.Add(
                sample.Time,
                new AttitudeSample { Attitude = Rotation.FromEuler(sample.Attitude), Rates = sample.Rates });
        else
            _invalid++;
    }

    /// <summary>The pose at a moment, if it is known.</summary>
    public PoseLookup Find(TimeSpan time, out Pose pose)
    {
        pose = default;
        PoseLookup position = _positions.Find(time, maxGap, out TimedPair<PositionSample> positions);
        PoseLookup attitude = _attitudes.Find(time, maxGap, out TimedPair<AttitudeSample> attitudes);
        if (position != PoseLookup.Known || attitude != PoseLookup.Known)
            return Worse(position, attitude);
        pose.Time = time;
        pose.TimeErrorSeconds = _timeError;
        (pose.Position, pose.VelocityNed) = Between(positions);
        pose.Attitude = Rotation.Slerp(attitudes.Before.Attitude, attitudes.After.Attitude, attitudes.Part);
        pose.Rates = Between(attitudes.Before.Rates, attitudes.After.Rates, attitudes.Part);
        return PoseLookup.Known;
    }

    /// <summary>
    /// The pose at a moment that the samples do not reach, at the velocity and the rates of the newest ones.
    /// </summary>
    /// <param name="time">The moment.</param>
    /// <param name="max">How far it may be extrapolated.</param>
    /// <param name="pose">Says how far it was extrapolated, from which its errors grow.</param>
    public PoseLookup Extrapolate(TimeSpan time, TimeSpan max, out Pose pose)
    {
        PoseLookup answer = Find(time, out pose);
        if (answer != PoseLookup.NotYet
            || !_positions.TryNewest(out TimeSpan positionTime, out PositionSample position)
            || !_attitudes.TryNewest(out TimeSpan attitudeTime, out AttitudeSample attitude))
            return answer;
        TimeSpan beyond = Later(time - positionTime, time - attitudeTime);
        if (beyond > max)
            return PoseLookup.NotYet;

        // One kind may reach beyond the moment: then it is extrapolated backwards, which is no worse.
        pose.Position = position.Position;
        pose.VelocityNed = position.VelocityNed.IsFinite ? position.VelocityNed : default;
        pose.Attitude = Rotation.Identity;
        pose = pose.After((time - positionTime).TotalSeconds);
        double seconds = (time - attitudeTime).TotalSeconds;
        pose.Rates = Between(attitude.Rates, attitude.Rates, 0);
        pose.Attitude = attitude.Attitude.After(pose.Rates, seconds);
        pose.Time = time;
        pose.TimeErrorSeconds = _timeError;
        pose.ExtrapolatedSeconds = beyond.TotalSeconds;
        return PoseLookup.Extrapolated;
    }

    private static TimeSpan Later(TimeSpan a, TimeSpan b) => a > b ? a : b;

    // What can never come is reported before what may still come.
    private static PoseLookup Worse(PoseLookup a, PoseLookup b)
    {
        if (a == PoseLookup.TooOld || b == PoseLookup.TooOld)
            return PoseLookup.TooOld;
        return a == PoseLookup.Gap || b == PoseLookup.Gap ? PoseLookup.Gap : PoseLookup.NotYet;
    }

    private static (GeodeticPosition Position, NedVector Velocity) Between(in TimedPair<PositionSample> pair)
    {
        NedVector startVelocity = pair.Before.VelocityNed;
        NedVector endVelocity = pair.After.VelocityNed;
        bool hasVelocity = startVelocity.IsFinite && endVelocity.IsFinite;
        if (pair.Seconds <= 0)
            return (pair.Before.Position, hasVelocity ? startVelocity : default);

        var frame = LocalNedFrame.IgnoringGeoid(pair.Before.Position);
        NedVector end = frame.ToNed(pair.After.Position) - NedPosition.Origin;
        double seconds = pair.Seconds;
        if (!hasVelocity)
        {
            startVelocity = end / seconds;
            endVelocity = startVelocity;
        }

        (double north, double northSpeed) = Cubic(
            end.North, startVelocity.North, endVelocity.North, seconds, pair.Part);
        (double east, double eastSpeed) = Cubic(end.East, startVelocity.East, endVelocity.East, seconds, pair.Part);
        (double down, double downSpeed) = Cubic(end.Down, startVelocity.Down, endVelocity.Down, seconds, pair.Part);
        return (frame.ToGeodetic(new NedPosition(north, east, down)), new NedVector(northSpeed, eastSpeed, downSpeed));
    }

    // From 0 to the end, with the speeds at both, and its derivative.
    private static (double Value, double Speed) Cubic(
        double end, double startSpeed, double endSpeed, double seconds, double part)
    {
        double p2 = part * part;
        double p3 = p2 * part;
        double value = (seconds * (p3 - (2 * p2) + part) * startSpeed) + (((3 * p2) - (2 * p3)) * end)
            + (seconds * (p3 - p2) * endSpeed);
        double speed = (((3 * p2) - (4 * part) + 1) * startSpeed) + (6 * (part - p2) * end / seconds)
            + (((3 * p2) - (2 * part)) * endSpeed);
        return (value, speed);
    }

    private static BodyRates Between(BodyRates a, BodyRates b, double part)
    {
        double roll = a.RollRadiansPerSecond + (part * (b.RollRadiansPerSecond - a.RollRadiansPerSecond));
        double pitch = a.PitchRadiansPerSecond + (part * (b.PitchRadiansPerSecond - a.PitchRadiansPerSecond));
        double yaw = a.YawRadiansPerSecond + (part * (b.YawRadiansPerSecond - a.YawRadiansPerSecond));
        var rates = BodyRates.FromRadiansPerSecond(roll, pitch, yaw);
        return rates.IsFinite ? rates : default;
    }

    private static bool IsValid(GeodeticPosition p)
        => Math.Abs(p.Latitude.Radians) <= Math.PI / 2 && Math.Abs(p.Longitude.Radians) <= 2 * Math.PI && p.IsValid;

    private struct PositionSample
    {
        public GeodeticPosition Position;
        public NedVector VelocityNed;
    }

    private struct AttitudeSample
    {
        public Rotation Attitude;
        public BodyRates Rates;
    }
}
