using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Communications;

// Frames on their way to a link: at once, or where it has a budget in their turn.
public sealed partial class CommunicationsManager
{
    // The shortest delay that there is.
    private static readonly TimeSpan AtOnce = TimeSpan.FromTicks(1);

    private LinkScheduler? MakeScheduler(int link)
    {
        if (!_options.SendBudgets.TryGetValue(link, out SendBudget? budget))
        {
            if (_options.SettingsOf(link).BytesPerSecond is not { } rate)
                return null;
            budget = new SendBudget { BytesPerSecond = rate };
        }

        bool isSigned = _signing?.IsSigned(link) == true;
        return new LinkScheduler(budget.Copy(), isSigned ? MavlinkFrame.SignatureLength : 0);
    }

    private void Forward(LinkPort port, in MavlinkFrame frame)
    {
        if (!port.AdmitsOut(frame))
            return;
        if (port.Scheduler is { } scheduler)
            scheduler.Put(
                new FrameToSend { Frame = frame }, SendClasses.Of(frame, keepsOrder: frame.IsSigned), Now);
        else
            port.Send(frame, Now);
    }

    // Of the copies for several links the first one is recorded that is sent for certain.
    private LinkPort? FindLinkToRecord(ulong links, in MavlinkFrame frame)
    {
        if (_recording is null)
            return null;
        LinkPort? found = null;
        foreach (LinkPort port in _ports)
        {
            bool isCandidate = (links & (1UL << port.Number)) != 0 && port.IsOpenTo(frame);
            if (isCandidate && port.Scheduler is null)
                return port;
            if (isCandidate)
                found ??= port;
        }

        return found;
    }

    private void SendOwn(
        LinkPort port, in MavlinkFrame frame, byte crcExtra, TimeSpan validUntil, bool isToBeRecorded)
    {
        if (!port.AdmitsOut(frame))
            return;
        var own = new FrameToSend
        {
            Frame = frame,
            IsOwn = true,
            CrcExtra = crcExtra,
            ValidUntil = validUntil,
            IsToBeRecorded = isToBeRecorded,
        };
        if (port.Scheduler is { } scheduler)
            scheduler.Put(own, SendClasses.Of(frame), Now);
        else
            SendNow(port, own);
    }

    private void SendWaiting()
    {
        foreach (LinkPort port in _ports)
        {
            while (port.Scheduler is { } scheduler && scheduler.TryTake(Now, out FrameToSend frame))
                SendNow(port, frame);
        }

        FlushLinks(Now);
    }

    private void FlushLinks(TimeSpan now)
    {
        foreach (LinkPort port in _ports)
        {
            if (port.FlushDue <= now)
                port.Flush();
        }
    }

    private void SendWaitingAtTheEnd()
    {
        foreach (LinkPort port in _ports)
        {
            while (port.Scheduler is { } scheduler && scheduler.TryTakeAtTheEnd(Now, out FrameToSend frame))
                SendNow(port, frame);
        }
    }

    // What is sent over one link is numbered on its own: what went to the others would look like a loss there. Numbers
    // and signatures rise in the order in which frames go out. What comes back is known by what was sent.
    private void SendNow(LinkPort port, in FrameToSend frame)
    {
        if (!frame.IsOwn)
        {
            port.Send(frame.Frame, Now);
            return;
        }

        MavlinkFrame numbered = frame.Frame.WithSequence(port.NextSequence(frame.Frame), frame.CrcExtra);
        _copies.Remember(numbered, Now);
        if (port.Scheduler?.Probe is { } probe && numbered.TryDecode(out Ping ping) && ping.TargetSystem == 0)
            probe.NoteSent(ping, Now);
        bool isSent = port.Send(
            _signing is null ? numbered : _signing.Sign(numbered, frame.CrcExtra, port.Number), Now);
        if (isSent && frame.IsToBeRecorded)
            RecordOwn(numbered, frame.CrcExtra);
    }

    // Time goes on during a unit of work: what is due meanwhile is due at once, and a delay is never zero.
    private TimeSpan Earliest(TimeSpan delay)
    {
        TimeSpan now = Now;
        foreach (LinkPort port in _ports)
        {
            if (port.Scheduler?.TimeToNext(now) is { } next && next < delay)
                delay = next;
            if (port.FlushDue != TimeSpan.MaxValue && port.FlushDue - now < delay)
                delay = port.FlushDue - now;
        }

        if (_exchange is not null && _exchangeDue - now < delay)
            delay = _exchangeDue - now;
        return delay > TimeSpan.Zero ? delay : AtOnce;
    }
}
