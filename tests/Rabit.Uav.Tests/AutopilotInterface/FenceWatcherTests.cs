using System;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>The autopilot's fence is read when it may have changed.</summary>
public sealed class FenceWatcherTests : IDisposable
{
    private readonly AutopilotRig _rig = new(new AutopilotOptions { RequestsRates = false, WatchesFence = true });
    private readonly MessageSubscriber<AutopilotFence> _fence;
    private readonly MavlinkMissionServer _autopilot = new(new MavlinkSender(1, 1));
    private int _handled;
    private bool _isSilent;

    public FenceWatcherTests()
        => _fence = _rig.Reactor.Workspace.Subscribe<AutopilotFence>(MessageNames.AutopilotFence);

    public void Dispose() => _rig.Dispose();

    [Fact]
    public void Fence_AtFirst_IsPostedAndIsNoChange()
    {
        Store(3);
        Run(2);
        Assert.Equal((true, 0, 3), (Fence.IsKnown, Fence.Changes, Fence.Items.Length));
    }

    [Fact]
    public void Fence_ChangedAndNotReported_IsReadWithin10Seconds()
    {
        Run(2);
        Assert.True(Fence.IsKnown);
        Store(4);
        Run(11);
        Assert.Equal((1, 4), (Fence.Changes, Fence.Items.Length));
        Run(30);
        Assert.Equal(1, Fence.Changes);
    }

    [Fact]
    public void Fence_WhoseCountIsReported_IsReadAtOnce()
    {
        Run(2);
        Store(4);
        _rig.Send(new ParamValue { ParamId = new Text16("FENCE_TOTAL"), Value = 4 });
        Run(1);
        Assert.Equal(1, Fence.Changes);
    }

    [Fact]
    public void Fence_OfAnAutopilotThatNamesIt_IsReadWhenTheNameChangesOnly()
    {
        Store(3);
        Run(1);
        _rig.Send(new MissionCurrent { FenceId = 7 });
        Run(2);
        int requests = Requests;
        Run(60);
        Assert.Equal(requests, Requests);
        Store(5);
        _rig.Send(new MissionCurrent { FenceId = 8 });
        Run(1);
        Assert.Equal((1, 5), (Fence.Changes, Fence.Items.Length));
        Store(0);
        _rig.Send(new MissionCurrent { FenceId = 0 });
        Run(1);
        Assert.Equal((2, 0), (Fence.Changes, Fence.Items.Length));
    }

    [Fact]
    public void Fence_OfAnAutopilotThatDoesNotAnswer_IsAskedForAgain()
    {
        _isSilent = true;
        Run(40);
        Assert.False(Fence.IsKnown);
        Store(3);
        _isSilent = false;
        Run(25);
        Assert.Equal((true, 0), (Fence.IsKnown, Fence.Changes));
    }

    private AutopilotFence Fence
    {
        get
        {
            _fence.Fetch();
            return _fence.Value;
        }
    }

    private int Requests => _rig.Sink.MessagesOf<MissionRequestList>().Count;

    private void Store(int corners) => _autopilot.Store(
        MavMissionType.Fence, Enumerable.Range(0, corners).Select(i => new MissionItemInt
        {
            Command = MavCmd.NavFencePolygonVertexInclusion,
            Param1 = corners,
            X = 470_000_000 + i,
            Y = 80_000_000,
        }).ToArray());

    private void Run(double seconds)
    {
        for (int i = 0; i < seconds * 20; i++)
        {
            if (i % 20 == 0)
                _rig.Send(AutopilotRig.Copter());
            for (; _handled < _rig.Sink.Frames.Count; _handled++)
            {
                if (!_isSilent)
                    _autopilot.Handle(_rig.Sink.Frames[_handled].Frame, _rig.Reactor.Now);
            }

            while (_autopilot.TryTakeFrame(_rig.Reactor.Now, out MavlinkFrame answer))
                _rig.Push(new LinkFrame { Frame = answer, Time = _rig.Reactor.Now, Index = i });
            _rig.Run(0.05);
        }
    }
}
