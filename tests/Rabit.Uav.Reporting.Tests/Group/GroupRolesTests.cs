using System;
using System.Linq;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Reporting.Tests;

public sealed class GroupRolesTests
{
    [Fact]
    public void Take_NoGroup_KeepsNothing()
    {
        var roles = new GroupRoles();
        roles.Take(TimeSpan.Zero, 1, default);

        Assert.Empty(roles.ToArray());
    }

    [Fact]
    public void Take_ShareAndTaskChange_KeepsEachChangeOnce()
    {
        var roles = new GroupRoles();
        GroupStatus first = new() { Lanes = 4, OwnShare = new LaneShare(2, 0, 4), DivisionAuthor = 2 };
        GroupStatus validating = first with
        {
            DivisionAuthor = 1,
            Validations =
                [new ValidationTask { Finder = 3, Number = 7, Validator = 2, State = ValidationState.Awarded }],
        };
        for (int second = 0; second < 5; second++)
            roles.Take(TimeSpan.FromSeconds(second), 2, first);
        for (int second = 5; second < 10; second++)
            roles.Take(TimeSpan.FromSeconds(second), 2, validating);

        Assert.Equal([0, 5], roles.ToArray().Select(r => (int)r.Time.TotalSeconds));
        Assert.True(roles.ToArray()[0].DividesLanes);
        Assert.Equal((3, 7), (roles.ToArray()[1].ValidatedFinder, roles.ToArray()[1].ValidatedNumber));
        Assert.False(roles.ToArray()[1].DividesLanes);
    }

    [Fact]
    public void Take_TargetThatWeFollow_IsOurRoleUntilItIsOver()
    {
        var roles = new GroupRoles();
        var task = new FollowTask { Finder = 3, Number = 4, Follower = 2, State = FollowState.Awarded };
        roles.Take(TimeSpan.Zero, 2, new GroupStatus { Lanes = 1, Followings = [task] });
        roles.Take(TimeSpan.FromSeconds(1), 2, new GroupStatus
        {
            Lanes = 1,
            Followings = [task with { State = FollowState.Closed, Result = FollowResult.Followed }],
        });

        Assert.Equal([(3, 4), (0, 0)], roles.ToArray().Select(r => ((int)r.FollowedFinder, (int)r.FollowedNumber)));
    }

    [Fact]
    public void Take_TaskOfAnotherValidator_IsNoRoleOfOurs()
    {
        var roles = new GroupRoles();
        roles.Take(TimeSpan.Zero, 1, new GroupStatus
        {
            Lanes = 1,
            Validations = [new ValidationTask { Finder = 3, Validator = 2, State = ValidationState.Awarded }],
        });

        Assert.Equal(0, Assert.Single(roles.ToArray()).ValidatedFinder);
    }
}
