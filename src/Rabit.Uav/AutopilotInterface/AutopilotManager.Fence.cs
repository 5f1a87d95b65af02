using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

// The fence that the autopilot has, while others may change it.
public sealed partial class AutopilotManager
{
    private readonly MessagePublisher<AutopilotFence> _fenceMessage;
    private FenceWatcher? _fence;
    private int _fenceWrites;

    private bool IsFenceBusy => _fence is { IsBusy: true };

    private void TakeFenceFrame(in LinkFrame frame)
    {
        if (_fence is not null && _tracker.IsFromAutopilot(frame.Frame))
            _fence.Handle(frame.Frame, Now);
    }

    private void RunFence()
    {
        if (_fence is null)
            return;
        int writes = _setup?.FenceWrites ?? 0;
        if (writes != _fenceWrites)
        {
            _fenceWrites = writes;
            _fence.Forget(Now);
        }

        _fence.Run(Now, _tracker.State.IsConnected && !IsSetupBusy);
        while (_tracker.State.IsConnected && _fence.TryTakeFrame(Now, out MavlinkFrame frame))
            _ = _outgoing.Push(new OutgoingFrame { Frame = frame });
        if (!_fence.TryTakeReport(out AutopilotFence report))
            return;
        if (report.Changes != _fenceMessage.Value.Changes)
            Log($"the autopilot's fence was changed: it has {report.Items.Length} items");
        _fenceMessage.Value = report;
        _fenceMessage.Post();
    }
}
