using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Tests.Shared;
using Rabit.Uav.Messages;
using Rabit.Uav.SensorFusion;

namespace Rabit.Uav.Tests.SensorFusion.Moving;

/// <summary>
/// A target that goes through a part of the picture where nothing is seen, such as under trees: two pictures a second,
/// it is reported with 90 % where it can be seen, 0.7 m off, among reports of nothing. Its speed and heading change
/// a little all the time, hidden or not.
/// </summary>
internal sealed class OcclusionRun
{
    private const double BeforeSeconds = 15;
    private const double AfterSeconds = 15;
    private const double Sigma = 0.7;
    private const double Clutter = 0.1;

    /// <param name="seed">Of all that is random.</param>
    /// <param name="rig">Sensor Fusion.</param>
    /// <param name="name">The class of the target.</param>
    /// <param name="speed">Metres per second, at the start.</param>
    /// <param name="hiddenMetres">How long the part of its way is on which it is hidden.</param>
    public OcclusionRun(int seed, FusionRig rig, TargetClassName name, double speed, double hiddenMetres)
    {
        var random = new SeededNumbers(seed);
        double hiddenFrom = speed * BeforeSeconds;
        double halfWay = hiddenFrom + (hiddenMetres / 2);
        (double north, double east, double heading, double way, double seen) = (-halfWay, 0, 0, 0, 0);
        while (seen < AfterSeconds)
        {
            // About as much as the models of both classes allow a target that goes on.
            double now = Math.Max(0.5 * speed, speed * (1 + (0.05 * random.Gauss())));
            heading += 0.03 * random.Gauss();
            (north, east) = (north + (0.5 * now * Math.Cos(heading)), east + (0.5 * now * Math.Sin(heading)));
            way += 0.5 * now;
            bool isHidden = way > hiddenFrom && way < hiddenFrom + hiddenMetres;
            List<TargetReport> reports = Clutters(random, name, halfWay).ToList();
            if (!isHidden && random.Uniform(0, 1) < 0.9)
                reports.Add(FusionRig.Report(
                    north + (Sigma * random.Gauss()), east + (Sigma * random.Gauss()), name, Sigma));
            rig.Observe(0, 0, halfWay + 60, halfWay + 60, [.. reports]);
            HiddenSeconds += isHidden ? 0.5 : 0;
            seen += way < hiddenFrom + hiddenMetres ? 0 : 0.5;
            Note(rig, way < hiddenFrom, north, east, 3 + (2 * speed));
        }

        Counters = rig.Counters;
    }

    /// <summary>How long it was hidden.</summary>
    public double HiddenSeconds { get; }

    /// <summary>The track of the target before it was hidden.</summary>
    public int IdBefore { get; private set; }

    /// <summary>The track of the target at the end.</summary>
    public int IdAfter { get; private set; }

    /// <summary>Whether it has the track at the end that it had before.</summary>
    public bool IsKept => IdBefore > 0 && IdBefore == IdAfter;

    /// <summary>In how many pictures more than one track was confirmed: one target has two, or clutter one.</summary>
    public int Doubled { get; private set; }

    public SensorFusionCounters Counters { get; }

    private static IEnumerable<TargetReport> Clutters(SeededNumbers random, TargetClassName name, double halfWay)
    {
        double reach = halfWay + 60;
        if (random.Uniform(0, 1) < Clutter)
            yield return FusionRig.Report(random.Uniform(-reach, reach), random.Uniform(-reach, reach), name, Sigma);
    }

    private void Note(FusionRig rig, bool isBefore, double north, double east, double nearMetres)
    {
        TargetTrack[] confirmed = rig.Tracks.Where(t => t.State == TrackState.Confirmed).ToArray();
        Doubled += confirmed.Length > 1 ? 1 : 0;
        int id = confirmed.Where(t => Distance(t, north, east) < nearMetres).Select(t => t.Id).FirstOrDefault();
        if (isBefore)
            IdBefore = id;
        else
            IdAfter = id;
    }

    private static double Distance(TargetTrack track, double north, double east)
    {
        (double n, double e) = (FusionRig.PlaceOf(track).North - north, FusionRig.PlaceOf(track).East - east);
        return Math.Sqrt((n * n) + (e * e));
    }
}
