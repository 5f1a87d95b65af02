using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Web.Collecting;

namespace Rabit.Uav.Web.State;

/// <summary>
/// A vehicle of the page: takes what its manager fetched, keeps the flight so far, and writes the values.
/// </summary>
internal sealed class LiveVehicle
{
    private readonly LivePageManager _manager;
    private readonly string _prefix;
    private readonly string _name;
    private readonly VehicleItems _vehicle;
    private readonly PlanItems _plan;
    private readonly PathSeries _path;
    private readonly SeenCells _seen;
    private readonly TrackItems _tracks;
    private readonly LinkItems _links;
    private readonly ManagerItems _managers;
    private readonly LogItems _log;
    private FlightMoment? _last;

    public LiveVehicle(int index, RabitReactor reactor, LiveVehicleOptions options)
    {
        _prefix = index.ToString(CultureInfo.InvariantCulture);
        _name = options.Name ?? "vehicle " + (index + 1).ToString(CultureInfo.InvariantCulture);
        IReadOnlyList<string> names = [.. reactor.Select(m => m.Name)];
        _manager = new LivePageManager(names, options.LinkCount, options.ShowsOtherVehicles);
        _vehicle = new VehicleItems(_prefix);
        _plan = new PlanItems(_prefix);
        _path = new PathSeries(_prefix);
        _seen = new SeenCells(_prefix);
        _tracks = new TrackItems(_prefix, Pictures, options.ImageChips);
        _links = new LinkItems(_prefix);
        _managers = new ManagerItems(
            _prefix, names, name => reactor.IsWired ? reactor.RealStepTime(name) : default);
        _log = new LogItems(_prefix, options.Log);
        Commands = new CommandDesk(_prefix, options.Operator, () => reactor.Now);
        reactor.Add(_manager);
    }

    public CommandDesk Commands { get; }

    public PageChips Pictures { get; } = new();

    /// <summary>Moments that were dropped because the page did not take them in time.</summary>
    public long Dropped => _manager.Dropped;

    /// <summary>Writes what has changed since the last time. Thread of the page.</summary>
    public void Write(ItemWriter writer, PageState state, TimeSpan realTime)
    {
        while (_manager.Moments.TryRead(out FlightMoment? moment))
        {
            _path.Add(moment);
            _seen.Mark(moment);
            _last = moment;
        }

        writer.Object(_prefix + "/about").Text("name", _name, 60).Flag("commands", Commands.IsOpen).End();
        Commands.Write(writer);
        if (_last is not { } last)
            return;
        _plan.Write(writer, state, last.Mission.Plan);
        _seen.Write(writer, state);
        _path.Write(writer, state);
        _tracks.Write(writer, state, last.Tracks);
        _links.Write(writer, last);
        _managers.Write(writer, last, realTime);
        _log.Write(writer, last.Texts);
        _vehicle.Write(writer, state, last);
    }
}
