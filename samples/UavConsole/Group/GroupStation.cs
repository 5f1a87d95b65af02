using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>The ground station of a simulated group: what it gives by the command line, and its log.</summary>
internal sealed class GroupStation
{
    private readonly Queue<ScriptedCommand> _script;
    private readonly List<(ScriptedCommand Script, StationCommand Command)> _given = [];

    /// <param name="station">The station.</param>
    /// <param name="script">What it commands, in any order.</param>
    /// <param name="log">Takes what it gave, and who obeyed.</param>
    public GroupStation(SimulatedGroundStation station, IEnumerable<ScriptedCommand> script, RunLog log)
    {
        (Station, Log) = (station, log);
        _script = new Queue<ScriptedCommand>(script.OrderBy(c => c.At));
        station.OnDone = (now, command) => log.Note(now, command.Name + ": " + command.Answer);
    }

    /// <summary>Any thread may command it.</summary>
    public SimulatedGroundStation Station { get; }

    public RunLog Log { get; }

    /// <summary>What was not due before the end; after it.</summary>
    public IReadOnlyCollection<ScriptedCommand> NotGiven => _script;

    /// <summary>What was given, and answered by no vehicle, with what is known of it; after the end.</summary>
    public IEnumerable<(ScriptedCommand Script, string Answer)> NotAnswered
        => _given.Where(g => g.Command.Answers.All(a => a.Result is null)).Select(g => (g.Script, g.Command.Answer));

    /// <summary>Gives what is due; the thread that simulates.</summary>
    public void Update(TimeSpan now)
    {
        while (_script.Count > 0 && _script.Peek().At <= now)
        {
            ScriptedCommand due = _script.Dequeue();
            _given.Add((due, Station.Command(due.Vehicle, due.Command, due.TrackId)));
        }
    }
}
