using System.Collections.Generic;
using System.Collections.Immutable;
using System.Globalization;
using System.Linq;
using System.Threading;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// A command that a simulated ground station sends to one vehicle or to all of them, and what became of it. Any thread
/// may read it.
/// </summary>
public sealed class StationCommand
{
    private Progress _progress = new([], false, string.Empty); // replaced by the station, read by any thread

    internal StationCommand(byte target, OperatorCommand command, int trackId)
        => (Target, Command, TrackId) = (target, command, trackId);

    /// <summary>The system id of the vehicle; 0 for all.</summary>
    public byte Target { get; }

    /// <summary>What to do.</summary>
    public OperatorCommand Command { get; }

    /// <summary>The track that it is about; 0 for none. Each vehicle numbers its tracks itself.</summary>
    public int TrackId { get; }

    /// <summary>The command as text: "return of vehicle 2".</summary>
    public string Name
    {
        get
        {
            string track = TrackId == 0 ? string.Empty : " track " + Number(TrackId);
            string what = Command == OperatorCommand.SkipLane ? "skip lane" : Command.ToString().ToLowerInvariant();
            return what + track + (Target == 0 ? " of all" : " of vehicle " + Number(Target));
        }
    }

    /// <summary>Whether nothing more is sent: all have answered, or some never did.</summary>
    public bool IsDone => Current.IsDone;

    /// <summary>The vehicles that it is for, in the order of their system ids.</summary>
    public ImmutableArray<StationAnswer> Answers => Current.Answers;

    /// <summary>What became of it, as text: "accepted by 1, 3; no answer of 2".</summary>
    public string Answer
    {
        get
        {
            Progress progress = Current;
            if (progress.Fault.Length > 0)
                return progress.Fault;
            IEnumerable<string> parts =
            [
                Of("accepted by ", progress.Answers.Where(a => a.Result == MavResult.Accepted)),
                Of("refused by ", progress.Answers.Where(a => a.Result is not (null or MavResult.Accepted))),
                Of(
                    progress.IsDone ? "no answer of " : "no answer yet of ",
                    progress.Answers.Where(a => a.Result is null)),
            ];
            return string.Join("; ", parts.Where(p => p.Length > 0));
        }
    }

    private Progress Current => Volatile.Read(ref _progress);

    internal void Refuse(string fault) => Volatile.Write(ref _progress, new Progress([], true, fault));

    internal void Set(IEnumerable<StationAnswer> answers, bool isDone)
        => Volatile.Write(ref _progress, new Progress([.. answers], isDone, string.Empty));

    private static string Of(string what, IEnumerable<StationAnswer> answers)
    {
        string who = string.Join(", ", answers.Select(a => Number(a.SystemId)));
        return who.Length == 0 ? string.Empty : what + who;
    }

    private static string Number(int number) => number.ToString(CultureInfo.InvariantCulture);

    private sealed record Progress(ImmutableArray<StationAnswer> Answers, bool IsDone, string Fault);
}
