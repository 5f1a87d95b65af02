using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>What the vehicles of a group said of the targets that they were to validate. Immutable.</summary>
/// <param name="tasks">As one vehicle knows them.</param>
internal sealed class GroupVerdicts(IEnumerable<ValidationTask> tasks)
{
    // What the operator rejected has the state of its track.
    private readonly ValidationTask[] _tasks = tasks
        .Where(t => t.State == ValidationState.Closed && t.Result != ValidationResult.Unknown)
        .Where(t => !t.IsRejectedByOperator).ToArray();

    /// <summary>Whether the result that is nearest to a track, of the same class and marker, is a rejection.</summary>
    public bool AreRejection(TargetTrack track) => _tasks
        .Where(t => t.Class == track.Class && t.MarkerId == track.MarkerId)
        .Select(t => (Task: t, Metres: TargetScoring.MetresBetween(t.Position, track.Position)))
        .Where(t => t.Metres <= TargetScoring.GateMetres)
        .OrderBy(t => t.Metres).ThenBy(t => t.Task.Result)
        .Select(t => t.Task.Result).FirstOrDefault() == ValidationResult.Rejected;
}
