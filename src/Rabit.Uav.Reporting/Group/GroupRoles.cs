using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>Keeps when the role of a vehicle in its group changed. For one thread.</summary>
internal sealed class GroupRoles
{
    private const int MaxChanges = 2_000;

    private readonly List<GroupRole> _changes = [];

    public GroupStatus Latest { get; private set; }

    public void Take(TimeSpan now, byte systemId, in GroupStatus group)
    {
        Latest = group;
        if (systemId == 0 || _changes.Count >= MaxChanges || (group.Lanes == 0 && group.Members.Length == 0))
            return;
        ValidationTask task = group.Validations
            .FirstOrDefault(t => t.Validator == systemId && t.State == ValidationState.Awarded);
        FollowTask follow = group.Followings
            .FirstOrDefault(t => t.Follower == systemId && t.State != FollowState.Closed);
        var role = new GroupRole
        {
            Time = now,
            DividesLanes = group.DivisionAuthor == systemId,
            Share = group.OwnShare,
            ValidatedFinder = task.Finder,
            ValidatedNumber = task.Number,
            ValidatedClass = task.Class,
            FollowedFinder = follow.Finder,
            FollowedNumber = follow.Number,
            FollowedClass = follow.Class,
        };
        if (_changes.Count == 0 || _changes[_changes.Count - 1] with { Time = now } != role)
            _changes.Add(role);
    }

    public GroupRole[] ToArray() => _changes.ToArray();
}
