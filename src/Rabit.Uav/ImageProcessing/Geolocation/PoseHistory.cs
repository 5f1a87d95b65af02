using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// Positions and attitudes of the last seconds, from which the pose at a moment is interpolated: attitude by SLERP,
/// position by a cubic through positions and velocities (Hermite). It is extrapolated beyond the newest only where that
/// is asked for. Fixed memory; for one thread.
/// </summary>
/// <remarks>
/// A gimbal that reported its attitude once is held to it: while it goes on, a pose waits for its samples as for the
/// others, and where it stopped there is no pose, since the angles that it was pointed by may not be where it points.
/// </remarks>
internal sealed class PoseHistory(TimeSpan maxGap, bool usesGimbal = true)
{
    // At 50 attitudes and 10 positions a second some 10 and 25 s; a picture is asked for within half a second.
    private const int AttitudesKept = 512;
    private const int PositionsKept = 256;
    private const int GimbalsKept = 256;

    // Samples may come a little out of order, and a link may pause. Two that are further than this from the newest one
    // are of a clock that was set again, or came after a pause; one is nothing.
    private static readonly TimeSpan MaxStep = TimeSpan.FromSeconds(2);

    // Gimbals report a few times a second, some only once.
    private static readonly TimeSpan MaxGimbalGap = TimeSpan.OfSeconds(1.5);
    private static readonly TimeSpan MaxGimbalStep = TimeSpan.FromSeconds(5);

    private readonly TimedRing<PositionSample> _positions = new(PositionsKept, MaxStep);
    private readonly TimedRing<AttitudeSample> _attitudes = new(AttitudesKept, MaxStep);
    private readonly TimedRing<GimbalSample> _gimbals = new(GimbalsKept, MaxGimbalStep);
    private long _invalid;
    private double _timeError;

    /// <summary>
    /// Samples that were not used: not a number, out of range, of a moment that was there already, too old, or with a
    /// time that no other one agrees with.
    /// </summary>
    public long Refused => _invalid + _positions.Refused + _attitudes.Refused + _gimbals.Refused;

    /// <summary>How often time jumped back, so that all before was forgotten.</summary>
    public long Restarts => _positions.Restarts + _attitudes.Restarts;

    public void Add(in PoseSample sample)
    {
        if (sample.TimeErrorSeconds >= 0 && sample.TimeErrorSeconds < MaxStep.ExactSeconds)
            _timeError = sample.TimeErrorSeconds;
        if (sample.Kind == PoseSampleKind.Position && IsValid(sample.Position))
            _positions.Add(
                sample.Time, new PositionSample { Position = sample.Position, VelocityNed = sample.VelocityNed });
        else if (sample.Kind == PoseSampleKind.Attitude && sample.Attitude.IsFinite)
            _attitudes.Add(
                sample.Time,
                new AttitudeSample { Attitude = Rotation.FromEuler(sample.Attitude), Rates = sample.Rates });
        else if (sample.Kind == PoseSampleKind.Gimbal && sample.Gimbal.Angles.IsFinite)
            AddGimbal(sample.Time, sample.Gimbal);
        else
            _invalid++;
    }

    /// <summary>Whether the gimbal reported its attitude once, and not around a moment.</summary>
    public bool IsGimbalSilent(TimeSpan time)
        => _gimbals.TryNewest(out TimeSpan newest, out _) && time - newest > MaxGimbalGap;

    /// <summary>The pose at a moment, if it is known.</summary>
    public PoseLookup Find(TimeSpan time, out Pose pose)
    {
        PoseLookup gimbal = FindGimbal(time, out GimbalAttitude? attitude);
        PoseLookup answer = Worse(FindBody(time, out pose), gimbal);
        if (answer == PoseLookup.Known)
            pose.Gimbal = attitude;
        else
            pose = default;
        return answer;
    }

    /// <summary>
    /// The pose at a moment that the samples do not reach, at the velocity and the rates of the newest ones; the gimbal
    /// is taken to stand still.
    /// </summary>
    /// <param name="time">The moment.</param>
    /// <param name="max">How far it may be extrapolated.</param>
    /// <param name="pose">Says how far it was extrapolated, from which its errors grow.</param>
    public PoseLookup Extrapolate(TimeSpan time, TimeSpan max, out Pose pose)
    {
        PoseLookup gimbal = FindGimbal(time, out GimbalAttitude? attitude);
        PoseLookup body = FindBody(time, out pose);
        if (gimbal == PoseLookup.NotYet && TryHoldGimbal(time, out attitude))
            gimbal = PoseLookup.Extrapolated;
        if (body == PoseLookup.NotYet && TryExtrapolateBody(time, max, out pose))
            body = PoseLookup.Extrapolated;
        PoseLookup answer = Worse(body, gimbal);
        if (answer is PoseLookup.Known or PoseLookup.Extrapolated)
            pose.Gimbal = attitude;
        else
            pose = default;
        return answer;
    }

    private PoseLookup FindBody(TimeSpan time, out Pose pose)
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

    private bool TryExtrapolateBody(TimeSpan time, TimeSpan max, out Pose pose)
    {
        pose = default;
        if (!_positions.TryNewest(out TimeSpan positionTime, out PositionSample position)
            || !_attitudes.TryNewest(out TimeSpan attitudeTime, out AttitudeSample attitude))
            return false;
        TimeSpan beyond = Later(time - positionTime, time - attitudeTime);
        if (beyond > max)
            return false;

        // One kind may reach beyond the moment: then it is extrapolated backwards, which is no worse.
        pose.Position = position.Position;
        pose.VelocityNed = position.VelocityNed.IsFinite ? position.VelocityNed : default;
        pose.Attitude = Rotation.Identity;
        pose = pose.After((time - positionTime).ExactSeconds);
        double seconds = (time - attitudeTime).ExactSeconds;
        pose.Rates = Between(attitude.Rates, attitude.Rates, 0);
        pose.Attitude = attitude.Attitude.After(pose.Rates, seconds);
        pose.Time = time;
        pose.TimeErrorSeconds = _timeError;
        pose.ExtrapolatedSeconds = beyond.ExactSeconds;
        return true;
    }

    private static TimeSpan Later(TimeSpan a, TimeSpan b) => a > b ? a : b;

    // What can never come is reported before what may still come.
    private static PoseLookup Worse(PoseLookup a, PoseLookup b)
    {
        if (a == PoseLookup.TooOld || b == PoseLookup.TooOld)
            return PoseLookup.TooOld;
        if (a == PoseLookup.Gap || b == PoseLookup.Gap)
            return PoseLookup.Gap;
        if (a == PoseLookup.NotYet || b == PoseLookup.NotYet)
            return PoseLookup.NotYet;
        return a == PoseLookup.Extrapolated || b == PoseLookup.Extrapolated
            ? PoseLookup.Extrapolated
            : PoseLookup.Known;
    }

    private void AddGimbal(TimeSpan time, in GimbalAttitude gimbal)
    {
        if (usesGimbal)
            _gimbals.Add(
                time, new GimbalSample { Attitude = Rotation.FromEuler(gimbal.Angles), Frame = gimbal.Frame });
    }

    // Null, and known, where no gimbal reports its attitude.
    private PoseLookup FindGimbal(TimeSpan time, out GimbalAttitude? gimbal)
    {
        gimbal = null;
        if (_gimbals.Count == 0)
            return PoseLookup.Known;
        PoseLookup answer = _gimbals.Find(time, MaxGimbalGap, out TimedPair<GimbalSample> pair);
        if (answer == PoseLookup.Known)
            gimbal = Between(pair);
        return answer;
    }

    private bool TryHoldGimbal(TimeSpan time, out GimbalAttitude? gimbal)
    {
        bool isThere = _gimbals.TryNewest(out TimeSpan newest, out GimbalSample sample);
        gimbal = new GimbalAttitude(sample.Attitude.ToEuler(), sample.Frame);
        return isThere && time - newest <= MaxGimbalGap;
    }

    private static GimbalAttitude Between(in TimedPair<GimbalSample> pair)
    {
        bool isNearer = pair.Part < 0.5;
        Rotation attitude = pair.Before.Frame == pair.After.Frame
            ? Rotation.Slerp(pair.Before.Attitude, pair.After.Attitude, pair.Part)
            : isNearer ? pair.Before.Attitude : pair.After.Attitude;
        return new GimbalAttitude(attitude.ToEuler(), isNearer ? pair.Before.Frame : pair.After.Frame);
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

    private struct GimbalSample
    {
        public Rotation Attitude;
        public GimbalFrame Frame;
    }

    private struct AttitudeSample
    {
        public Rotation Attitude;
        public BodyRates Rates;
    }
}
