using System;
using Xunit;

namespace Rabit.Core.Tests.Wiring;

/// <summary>Managers that are absent on purpose, in the faults of the wiring.</summary>
public sealed class AbsentManagerTests
{
    private static readonly AbsentManager Camera = new("camera", "is not on this robot")
    {
        Publishes = ["picture"],
        Sends = ["pictures"],
        Receives = ["triggers"],
    };

    [Fact, Trait("Clause", "4.2")]
    public void LeaveOut_PartThatOthersNeed_IsAFaultThatNamesIt()
    {
        var reactor = new RabitReactor(new VirtualTime(1))
        {
            new Wired("a", needsPicture: true), new Wired("b", needsPicture: true), new Wired("c", isOnTheQueues: true),
        };
        reactor.Workspace.LeaveOut(Camera);

        var fault = Assert.Throws<RabitWiringException>(reactor.Start);

        Assert.Equal(
            [
                "'a', 'b' subscribe to message 'picture', but it has no publisher: 'camera', which is not on this "
                    + "robot, would publish it.",
                "Queue 'pictures' has no sender, but 'c' receives it: 'camera', which is not on this robot, would send "
                    + "to it.",
                "Queue 'triggers' has no receiver, but 'c' sends to it: 'camera', which is not on this robot, would "
                    + "receive it.",
            ],
            fault.Faults);
    }

    [Fact, Trait("Clause", "4.2")]
    public void LeaveOut_PartThatOthersTake_IsNoFault()
    {
        var reactor = new RabitReactor(new VirtualTime(1))
        {
            new Wired("a", needsPicture: true), new Wired("c", isOnTheQueues: true),
        };
        reactor.Workspace.LeaveOut(Camera);
        reactor.Workspace.Publish<int>("picture");
        reactor.Workspace.Send<int>("pictures");
        reactor.Workspace.Receive<int>("triggers");

        reactor.Start();
        reactor.Stop();

        Assert.Equal(0, reactor.Finish().ExitCode);
    }

    [Fact]
    public void LeaveOut_AfterTheStart_Throws()
    {
        var reactor = new RabitReactor(new VirtualTime(1)) { new Wired("a") };
        reactor.Start();

        var fault = Assert.Throws<InvalidOperationException>(() => reactor.Workspace.LeaveOut(Camera));

        Assert.Contains("'camera'", fault.Message, StringComparison.Ordinal);
        reactor.Stop();
        reactor.Finish();
    }

    private sealed class Wired : RabitManager
    {
        public Wired(string name, bool needsPicture = false, bool isOnTheQueues = false)
            : base(name)
        {
            if (needsPicture)
                Subscribe<int>("picture");
            if (!isOnTheQueues)
                return;
            Receive<int>("pictures");
            Send<int>("triggers");
        }

        protected override void ExecuteUnitOfWork()
        {
        }
    }
}
