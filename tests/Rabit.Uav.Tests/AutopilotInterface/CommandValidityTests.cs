using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>Commands that are no longer renewed: Autopilot Interface returns by itself.</summary>
public class CommandValidityTests
{
    private static readonly TimeSpan Validity = TimeSpan.FromSeconds(3);

    [Fact]
    public void Validity_Passed_ReturnsOnceByItself()
    {
        using ScriptedAutopilot copter = Flying();
        Go(copter);
        copter.Run(2.9);
        Assert.Equal((uint)CopterMode.Guided, copter.Mode);
        copter.Run(1);
        Assert.Equal((uint)CopterMode.Rtl, copter.Mode);
        Assert.True(copter.Rig.Authority.IsReturningByItself);
        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
        int sent = copter.Received.Count;
        copter.Run(10);
        Assert.Equal(sent, copter.Received.Count);
    }

    [Fact]
    public void Validity_Renewed_GoesOnAndSendsNothingAgain()
    {
        using ScriptedAutopilot copter = Flying();
        long id = Go(copter);
        copter.Run(1);
        int sent = copter.Received.Count;
        for (int second = 0; second < 20; second++)
        {
            Go(copter, id);
            copter.Run(1);
        }

        Assert.Equal(sent, copter.Received.Count);
        Assert.Single(copter.Answers, a => a.Id == id);
        Assert.Equal((uint)CopterMode.Guided, copter.Mode);
        copter.Run(4);
        Assert.Equal((uint)CopterMode.Rtl, copter.Mode);
    }

    [Theory]
    [InlineData(VehicleCommandKind.Return)]
    [InlineData(VehicleCommandKind.Land)]
    public void Validity_PassedInReturnOrLanding_ChangesNothing(VehicleCommandKind kind)
    {
        using ScriptedAutopilot copter = Flying();
        copter.GiveAndRun(kind, with: c => c with { Validity = Validity });
        uint mode = copter.Mode;
        int sent = copter.Received.Count;
        copter.Run(10);
        Assert.Equal((mode, sent), (copter.Mode, copter.Received.Count));
    }

    [Fact]
    public void Validity_PassedOnTheGroundOrAfterATakeover_SendsNothing()
    {
        using ScriptedAutopilot copter = Flying();
        copter.Say(new ExtendedSysState { LandedState = MavLandedState.OnGround });
        Go(copter);
        copter.Run(5);
        Assert.Equal((uint)CopterMode.Guided, copter.Mode);

        copter.Say(new ExtendedSysState { LandedState = MavLandedState.InAir });
        Go(copter);
        copter.Run(1);
        copter.Mode = (uint)CopterMode.Loiter;
        int sent = copter.Received.Count;
        copter.Run(10);
        Assert.Equal(((uint)CopterMode.Loiter, sent), (copter.Mode, copter.Received.Count));
    }

    [Fact]
    public void Validity_PassedWhileTheAutopilotDoesNotAnswer_IsTriedUntilItDoes()
    {
        using ScriptedAutopilot copter = Flying();
        Go(copter);
        copter.Run(1);
        copter.Script = (_, _) => null;
        copter.Run(20);
        Assert.Equal((uint)CopterMode.Guided, copter.Mode);
        copter.Script = copter.Accept;
        copter.Run(4);
        Assert.Equal((uint)CopterMode.Rtl, copter.Mode);
    }

    [Fact]
    public void Validity_NewCommandAfterwards_CommandsAgain()
    {
        using ScriptedAutopilot copter = Flying();
        Go(copter);
        copter.Run(5);
        Assert.True(copter.Rig.Authority.IsReturningByItself);
        Go(copter);
        copter.Run(2);
        Assert.False(copter.Rig.Authority.IsReturningByItself);
        Assert.Equal((uint)CopterMode.Guided, copter.Mode);
    }

    private static ScriptedAutopilot Flying()
    {
        ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Say(new ExtendedSysState { LandedState = MavLandedState.InAir });
        copter.Run(0.1);
        return copter;
    }

    private static long Go(ScriptedAutopilot copter, long? id = null)
        => copter.Give(VehicleCommandKind.GoTo, c => c with { Id = id ?? c.Id, Validity = Validity });
}
