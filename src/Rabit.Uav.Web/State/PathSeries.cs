using System;
using System.Collections.Generic;
using System.Globalization;
using Rabit.Uav.Messages;
using Rabit.Uav.Web.Collecting;

namespace Rabit.Uav.Web.State;

/// <summary>
/// The flight so far, evenly spaced over time, for the path and for scrolling back: in groups, of which only the last
/// one changes. When it is full every second sample goes, and from then on they are twice as far apart.
/// </summary>
internal sealed class PathSeries(string prefix)
{
    private const int MaxSamples = 1200;
    private const int GroupSize = 10;

    private readonly List<PathSample> _samples = [];
    private TimeSpan _spacing = TimeSpan.FromSeconds(1);
    private int _unwritten;   // the first sample that is not, or not as it is now, in the state

    public void Add(FlightMoment moment)
    {
        if (moment.Vehicle.PositionTime is null)
            return;
        if (_samples.Count > 0 && moment.Time - _samples[^1].Time < _spacing)
            return;
        if (_samples.Count == MaxSamples)
            Thin();
        _samples.Add(PathSample.Of(moment));
    }

    /// <summary>Writes the groups that have changed.</summary>
    public void Write(ItemWriter writer, PageState state)
    {
        int groups = (MaxSamples + GroupSize - 1) / GroupSize;
        for (int group = _unwritten / GroupSize; group * GroupSize < _samples.Count; group++)
            WriteGroup(writer, group);
        if (_unwritten == 0)
        {
            for (int group = (_samples.Count + GroupSize - 1) / GroupSize; group < groups; group++)
                state.Remove(KeyOf(group));
        }

        _unwritten = _samples.Count;
    }

    private void WriteGroup(ItemWriter writer, int group)
    {
        writer.Array(KeyOf(group));
        for (int i = group * GroupSize; i < Math.Min(_samples.Count, (group + 1) * GroupSize); i++)
            _samples[i].Write(writer);
        writer.End();
    }

    private string KeyOf(int group) => string.Create(CultureInfo.InvariantCulture, $"{prefix}/path/{group}");

    private void Thin()
    {
        int kept = 0;
        for (int i = 0; i < _samples.Count; i += 2)
            _samples[kept++] = _samples[i];
        _samples.RemoveRange(kept, _samples.Count - kept);
        _spacing *= 2;
        _unwritten = 0;
    }

    private readonly record struct PathSample(
        TimeSpan Time, double Latitude, double Longitude, double Height, double Speed, double YawDegrees,
        double Battery, MissionPhase Phase, double Coverage)
    {
        public static PathSample Of(FlightMoment moment)
        {
            VehicleState vehicle = moment.Vehicle;
            return new PathSample(
                moment.Time, vehicle.Position.Latitude.Degrees, vehicle.Position.Longitude.Degrees,
                vehicle.HeightAboveHomeMetres, vehicle.VelocityNed.HorizontalLength, vehicle.Attitude.Yaw.Degrees,
                vehicle.BatteryTime is null ? double.NaN : vehicle.BatteryRemaining, moment.Mission.Phase,
                moment.Mission.Coverage);
        }

        public void Write(ItemWriter writer)
            => writer.Inner().Number(Time.TotalSeconds, 1).Number(Latitude, 6).Number(Longitude, 6).Number(Height, 1)
                .Number(Speed, 1).Number(YawDegrees, 0).Number(Battery, 2).Number((int)Phase, 0).Number(Coverage, 3)
                .EndInner();
    }
}
