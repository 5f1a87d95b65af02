using System;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

// That one vehicle searches as long as lanes are left, whatever there is to follow.
internal sealed partial class MissionGroup
{
    // Until it is known that another one begins to follow, or is done.
    private static readonly TimeSpan SearcherMissedTime = TimeSpan.FromSeconds(2);

    private TimeSpan? _searcherMissed;

    // By what each vehicle has left of its share: who follows has none, once it is known.
    private bool AreLanesLeft
        => _division.Shares.Length == 0 || _division.Shares.Any(s => MetresLeftOf(s.SystemId) > 0);

    // Who was awarded a target follows it in a moment.
    private bool IsFollower(byte systemId)
        => _following?.Entries.Any(e => !e.IsOver && e.Task.Follower == systemId) == true;

    private int CountOtherSearchers(TimeSpan now) => _members.Present(now)
        .Count(m => m.Report.State == GroupMemberState.Available && !IsFollower(m.SystemId));

    // Others do not search, and we do not follow yet: so we do not begin to.
    private bool MustSearch(TimeSpan now) => AreLanesLeft && CountOtherSearchers(now) == 0;

    // A target that comes second to the lanes is kept until these are flown, or another vehicle searches.
    private bool IsSearchFirst(TimeSpan now)
    {
        bool isOwn = _own.State == GroupMemberState.Available && !IsFollower(SystemId);
        return AreLanesLeft && CountOtherSearchers(now) + (isOwn ? 1 : 0) <= 1;
    }

    // Two that were awarded a target each at the same time: the one with the lower system id searches. Where we are
    // alone we go on: whether others search is not known then.
    private bool IsMissedAsSearcher(TimeSpan now)
    {
        byte[] followers = _members.Present(now)
            .Where(m => m.Report.State == GroupMemberState.Following || IsFollower(m.SystemId))
            .Select(m => m.SystemId).ToArray();
        bool isMissed = followers.Length > 0 && SystemId < followers.Min() && MustSearch(now);
        _searcherMissed = isMissed ? _searcherMissed ?? now : null;
        return now - _searcherMissed >= SearcherMissedTime;
    }
}
