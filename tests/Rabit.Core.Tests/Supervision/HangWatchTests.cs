using System;
using System.Collections.Generic;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;
using Rabit.Core.Messages;
using Rabit.Core.Supervision;
using Rabit.Core.Tests.Messages;
using Rabit.Core.Tests.Queues;
using Rabit.Core.Tests.RealTimeKit;
using Rabit.Core.Tests.Time;
using Rabit.Core.Time;
using Rabit.Core.Wiring;
using Xunit;

namespace Rabit.Core.Tests.Supervision;

/// <summary>
/// Contract 4.5 on one thread: the manager moves on in front of each access of the watchdog to the mark of its stage.
/// </summary>
public sealed class HangWatchTests
{
    // The word, the time, the word again, and the compare-and-swap of the mark.
    private const int PointsOfCheck = 4;

    private static readonly TimeSpan PastTheLimit = TimeSpan.FromSeconds(6);

    private readonly List<ManagerHang> _calledBack = [];
    private readonly List<RabitLogEntry> _log = [];
    private readonly HangWatch<HeldUpPoints> _watch;
    private readonly SharedValue<ManagerStatus> _status = new(MessagePlaces.New("status"), default, isAlone: true);
    private readonly StatusEndpoint _endpoint;

    public HangWatchTests()
    {
        var clock = new RunClock(new ManualClock());
        var run = new ManagerRun(
            clock, new RabitLog(_log.Add, logRuns: false, clock), HangPolicy.Report.AndCall(_calledBack.Add),
            keepsStatistics: true, _ => { });
        _watch = new HangWatch<HeldUpPoints>(new RequestingManager("m", request: null), run);
        var binding = new MessageBinding<ManagerStatus>(
            new EndpointOwner("watchdog", isManager: false, wakeUp: null), EndpointRole.Publish, "status");
        binding.Bind(_status, firstOfOwner: null);
        _endpoint = new StatusEndpoint(binding, inheritsPriority: false);
    }

    [Theory, Trait("Clause", "4.5")]
    [InlineData(false)]
    [InlineData(true)]
    public void Check_ManagerLeavesInFrontOfEachAccess_FindsNothing(bool entersAgain)
    {
        for (int point = 1; point <= PointsOfCheck; point++)
        {
            _watch.Enter(ManagerStage.UnitOfWork, TimeSpan.Zero);
            HeldUpPoints.HoldUpAt(point, () =>
            {
                _watch.Leave(PastTheLimit);
                if (entersAgain)
                    _watch.Enter(ManagerStage.UnitOfWork, PastTheLimit);
            });

            _watch.Check(PastTheLimit, _endpoint);

            Assert.True(HeldUpPoints.WasHeldUp);
            AssertFound(0);
            _watch.Leave(PastTheLimit);
            Assert.Empty(_log);
        }
    }

    [Fact, Trait("Clause", "4.5")]
    public void Check_ManagerStaysToTheLastAccess_FindsThatItHangs()
    {
        _watch.Enter(ManagerStage.UnitOfWork, TimeSpan.Zero);
        HeldUpPoints.HoldUpAt(PointsOfCheck + 1, () => { });

        _watch.Check(PastTheLimit, _endpoint);

        Assert.False(HeldUpPoints.WasHeldUp);
        AssertFound(1);
        Assert.Equal(ManagerState.Hanging, _endpoint.Read().State);
        Assert.Equal("m", Assert.Single(_log).Source);
        HeldUpPoints.HoldUpAt(0, () => { });
    }

    // In the result, in the next status of the manager, by a post, and by the callback.
    private void AssertFound(int hangs)
    {
        ManagerStatus next = default;
        _watch.Describe(ref next);
        _watch.Found.Read(out long found);
        Assert.Equal(
            (hangs, hangs, hangs, hangs), (found, next.Hangs, _status.Version, _calledBack.Count));
    }
}
