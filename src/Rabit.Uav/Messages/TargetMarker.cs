using System;
using System.Collections.Generic;
using Rabit.Vision;

namespace Rabit.Uav.Messages;

/// <summary>The printed markers that a class of targets consists of: one of a family, or any. Immutable.</summary>
/// <param name="family">Which family.</param>
/// <param name="id">Which of them; null for any.</param>
public sealed class TargetMarker(MarkerFamily family, int? id = null)
{
    /// <summary>Which family.</summary>
    public MarkerFamily Family { get; } = family;

    /// <summary>Which of them; null for any.</summary>
    public int? Id { get; } = id;

    internal static int CountOf(MarkerFamily family) => family == MarkerFamily.ArUco4x4 ? 50 : 587;

    internal IEnumerable<string> FindFaults(TargetClass owner)
    {
        if (Family is not (MarkerFamily.ArUco4x4 or MarkerFamily.AprilTag36h11))
            yield return $"the marker of target class {owner.Name} is of the unknown family {(int)Family}";
        else if (Id is { } id && (id < 0 || id >= CountOf(Family)))
        {
            yield return $"the marker of target class {owner.Name} has the id {id}; "
                + $"{Family} has 0 to {CountOf(Family) - 1}";
        }

        if (owner.Colour is not null)
            yield return $"target class {owner.Name} has a colour and a marker; it can only have one of them";
    }

    internal bool Is(MarkerFamily family, int id) => Family == family && (Id is null || Id == id);
}
