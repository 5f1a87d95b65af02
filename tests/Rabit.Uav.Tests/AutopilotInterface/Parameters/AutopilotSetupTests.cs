using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface.Parameters;

/// <summary>Reading parameters, writing failsafes and fence, and writing back.</summary>
public sealed class AutopilotSetupTests
{
    private static readonly GeodeticPosition[] Corners =
    [
        GeodeticPosition.FromDegrees(47.397, 8.545, 0), GeodeticPosition.FromDegrees(47.399, 8.545, 0),
        GeodeticPosition.FromDegrees(47.399, 8.547, 0),
    ];

    [Fact]
    public void Run_OneNameOfTwoIsAnswered_TheOtherStaysUnknownAndAllIsComplete()
    {
        var rig = new SetupRig(SetupRig.Ardupilot());

        rig.Run(5);

        Assert.True(rig.Report.IsComplete);
        Assert.Equal((1500, double.NaN), (rig.ValueOf("RTL_ALT"), rig.ValueOf("RTL_ALT_M")));
        Assert.Equal(10.5, rig.ValueOf("BATT_LOW_VOLT"));
        Assert.Empty(rig.Server.Sets);
    }

    [Fact]
    public void Run_IntegerOfPx4_IsDecodedByItsBits()
    {
        var server = new ParameterServer(MavAutopilot.Px4);
        server.Values["COM_OBL_RC_ACT"] = (MavParamType.Int32, 3);
        server.Values["COM_OF_LOSS_T"] = (MavParamType.Real32, 0.5);
        var rig = new SetupRig(server, make: MavAutopilot.Px4);

        rig.Run(60);

        Assert.True(rig.Report.IsComplete);
        Assert.Equal((3, 0.5), (rig.ValueOf("COM_OBL_RC_ACT"), rig.ValueOf("COM_OF_LOSS_T")));
        Assert.True(double.IsNaN(rig.ValueOf("NAV_RCL_ACT")));
    }

    [Fact]
    public void Run_FramesLost_AreAskedForAgain()
    {
        ParameterServer server = SetupRig.Ardupilot();
        server.Lost = 5;
        var rig = new SetupRig(server);

        rig.Run(10);

        Assert.True(rig.Report.IsComplete);
        Assert.Equal(0, rig.ValueOf("FS_GCS_ENABLE"));
    }

    [Fact]
    public void Run_ChangedByTheOperator_IsReadAgain()
    {
        var rig = new SetupRig(SetupRig.Ardupilot());
        rig.Run(10);

        rig.Server.Values["FS_GCS_ENABLE"] = (MavParamType.Int8, 1);
        rig.Run(15);

        Assert.Equal(1, rig.ValueOf("FS_GCS_ENABLE"));
    }

    [Fact]
    public void Run_InFlight_SendsNothing()
    {
        var rig = new SetupRig(SetupRig.Ardupilot());
        rig.Vehicle = rig.Vehicle with { IsArmed = true };

        rig.Run(20);

        Assert.Empty(rig.Server.Reads);
        Assert.False(rig.Report.IsComplete);
    }

    [Fact]
    public void Run_SetsFailsafes_KeepsOriginalsBeforeTheFirstWrite()
    {
        var store = new MemoryOriginals();
        SetupRig rig = Writing(store);
        store.Saving = () => Assert.Empty(rig.Server.Sets);

        rig.Run(10);

        Assert.Equal(AutopilotSetupState.Done, rig.Report.Setup);
        Assert.Equal("4 parameters set", rig.Report.SetupText);
        Assert.Equal(
            [("BATT_FS_CRT_ACT", 1.0), ("BATT_FS_LOW_ACT", 2), ("FS_GCS_ENABLE", 1), ("FS_OPTIONS", 16)],
            rig.Server.Sets.OrderBy(s => s.Name, StringComparer.Ordinal));
        Assert.Equal(
            [("BATT_FS_CRT_ACT", 0.0), ("BATT_FS_LOW_ACT", 0), ("FS_GCS_ENABLE", 0), ("FS_OPTIONS", 20)],
            store.Kept!.Parameters.Select(p => (p.Name, p.Value)).OrderBy(p => p.Name, StringComparer.Ordinal));
    }

    [Fact]
    public void Run_OriginalsCannotBeKept_NothingIsWritten()
    {
        var store = new MemoryOriginals { Fault = "disk full" };
        SetupRig rig = Writing(store);

        rig.Run(10);

        Assert.Empty(rig.Server.Sets);
        Assert.Equal(
            (AutopilotSetupState.Failed, "nothing is written to the autopilot: disk full"),
            (rig.Report.Setup, rig.Report.SetupText));
    }

    [Fact]
    public void Run_ValueIsNotTaken_FailsAndNamesIt()
    {
        SetupRig rig = Writing(new MemoryOriginals());
        rig.Server.ReadOnly.Add("FS_GCS_ENABLE");

        rig.Run(20);

        Assert.Equal(
            (AutopilotSetupState.Failed, "the autopilot rejects FS_GCS_ENABLE"),
            (rig.Report.Setup, rig.Report.SetupText));
        Assert.Equal(2, rig.Server.Values["BATT_FS_LOW_ACT"].Value);
    }

    [Fact]
    public void Run_AfterTheFlight_IsWrittenBackOnTheGroundOnly()
    {
        var store = new MemoryOriginals();
        SetupRig rig = Writing(store);
        rig.Run(10);

        rig.Vehicle = rig.Vehicle with { IsArmed = true, LandedState = MavLandedState.InAir };
        rig.Run(10);
        rig.Vehicle = rig.Vehicle with { IsArmed = false };
        rig.Run(10);
        Assert.Equal(1, rig.Server.Values["FS_GCS_ENABLE"].Value);

        rig.Vehicle = rig.Vehicle with { LandedState = MavLandedState.OnGround };
        rig.Run(10);

        Assert.Equal(
            (0.0, 0, 20), (rig.Server.Values["FS_GCS_ENABLE"].Value, rig.Server.Values["BATT_FS_LOW_ACT"].Value,
                rig.Server.Values["FS_OPTIONS"].Value));
        Assert.Equal(AutopilotSetupState.Restored, rig.Report.Setup);
        Assert.Null(store.Kept);
    }

    [Fact]
    public void Run_ProgramIsToEndOnTheGround_IsWrittenBack()
    {
        var store = new MemoryOriginals();
        SetupRig rig = Writing(store);
        rig.Run(10);

        rig.IsStopping = true;
        rig.Run(5);

        Assert.Equal(0, rig.Server.Values["FS_GCS_ENABLE"].Value);
        Assert.Null(store.Kept);
    }

    [Fact]
    public void Run_StartedAgainWithOriginalsOnDisk_WritesThemBack()
    {
        var store = new MemoryOriginals();
        SetupRig first = Writing(store);
        first.Run(10);

        var second = new SetupRig(
            first.Server, new AutopilotSetupOptions { OriginalsFile = "originals.json" }, store);
        second.Run(10);

        Assert.Equal(AutopilotSetupState.Restored, second.Report.Setup);
        Assert.Equal(0, first.Server.Values["FS_GCS_ENABLE"].Value);
        Assert.Null(store.Kept);
    }

    // A start that only brings a vehicle home ends soon after it is down.
    [Fact]
    public void Run_StartedAgainInFlight_DelaysTheEndAsSoonAsItIsOnTheGround()
    {
        var store = new MemoryOriginals();
        SetupRig first = Writing(store);
        first.Run(10);
        var second = new SetupRig(
            first.Server, new AutopilotSetupOptions { OriginalsFile = "originals.json" }, store);
        VehicleState onGround = second.Vehicle;
        second.Vehicle = onGround with { IsArmed = true, LandedState = MavLandedState.InAir };
        second.Run(10);
        Assert.False(second.MustRestore);

        second.Vehicle = onGround;
        second.IsStopping = true;
        second.Run(0.1);
        Assert.True(second.MustRestore);
        second.Run(5);
        Assert.False(second.MustRestore);
        Assert.Equal(0, first.Server.Values["FS_GCS_ENABLE"].Value);
        Assert.Null(store.Kept);
    }

    [Fact]
    public void Run_StartedAgainToSetThemAgain_KeepsTheFirstOriginals()
    {
        var store = new MemoryOriginals();
        SetupRig first = Writing(store);
        first.Run(10);
        first.Server.Values["FS_THR_ENABLE"] = (MavParamType.Int8, 0);

        SetupRig second = Writing(store, first.Server);
        second.Run(10);

        Assert.Equal(0, store.Kept!.Parameters.Single(p => p.Name == "FS_GCS_ENABLE").Value);
        Assert.Equal(0, store.Kept!.Parameters.Single(p => p.Name == "FS_THR_ENABLE").Value);
        Assert.Equal(AutopilotSetupState.Done, second.Report.Setup);
    }

    [Fact]
    public void Run_OriginalsOfAnotherVehicle_AreRefusedAndKept()
    {
        var store = new MemoryOriginals { Kept = new Originals(7, [], null) };
        SetupRig rig = Writing(store);

        rig.Run(10);

        Assert.Equal(AutopilotSetupState.Failed, rig.Report.Setup);
        Assert.Equal("originals.json has the values of vehicle 7, not those of 1", rig.Report.SetupText);
        Assert.Empty(rig.Server.Sets);
        Assert.Equal(7, store.Kept!.SystemId);
    }

    [Fact]
    public void Run_UploadsFence_KeepsAndRestoresTheUsersFence()
    {
        var store = new MemoryOriginals();
        ParameterServer server = SetupRig.Ardupilot();
        server.Fence = [UsersItem(0), UsersItem(1), UsersItem(2), UsersItem(3)];
        var rig = new SetupRig(server, FenceOptions(), store);

        rig.Run(20);

        Assert.Equal("2 parameters set, fence of 3 corners uploaded", rig.Report.SetupText);
        Assert.Equal([473970000, 473990000, 473990000], server.Fence.Select(i => i.X));
        Assert.All(server.Fence, i => Assert.Equal(
            (MavCmd.NavFencePolygonVertexInclusion, MavFrame.Global, 3f), (i.Command, i.Frame, i.Param1)));
        Assert.Equal((1.0, 7.0), (server.Values["FENCE_ENABLE"].Value, server.Values["FENCE_TYPE"].Value));
        Assert.Equal(4, store.Kept!.Fence!.Count);

        rig.IsStopping = true;
        rig.Run(20);

        Assert.Equal([UsersItem(0).X, UsersItem(1).X, UsersItem(2).X, UsersItem(3).X], server.Fence.Select(i => i.X));
        Assert.Equal((0.0, 3.0), (server.Values["FENCE_ENABLE"].Value, server.Values["FENCE_TYPE"].Value));
    }

    [Fact]
    public void Run_UploadsFenceWhereThereWasNone_ClearsItAfterwards()
    {
        var rig = new SetupRig(SetupRig.Ardupilot(), FenceOptions(), new MemoryOriginals());
        rig.Run(20);
        Assert.Equal((3, 0), (rig.Server.Fence.Count, rig.Server.Clears));

        rig.IsStopping = true;
        rig.Run(20);

        Assert.Equal((0, 1), (rig.Server.Fence.Count, rig.Server.Clears));
    }

    [Fact]
    public void Run_WithoutTheOption_NoFenceIsTouched()
    {
        var rig = new SetupRig(
            SetupRig.Ardupilot(),
            new AutopilotSetupOptions { SetsFailsafes = true, OriginalsFile = "originals.json" },
            new MemoryOriginals());
        rig.Server.Fence = [UsersItem(0), UsersItem(1), UsersItem(2)];

        rig.Run(20);
        rig.IsStopping = true;
        rig.Run(20);

        Assert.Equal((3, 0, 0), (rig.Server.Fence.Count, rig.Server.Uploads, rig.Server.Clears));
        Assert.DoesNotContain("FENCE_TYPE", rig.Server.Reads);
    }

    private static MissionItemInt UsersItem(int seq) => new()
    {
        TargetSystem = 1,
        TargetComponent = 191,
        Seq = (ushort)seq,
        Command = MavCmd.NavFencePolygonVertexInclusion,
        Frame = MavFrame.Global,
        MissionType = MavMissionType.Fence,
        Param1 = 4,
        X = 470000000 + seq,
        Y = 80000000,
    };

    private static AutopilotSetupOptions FenceOptions() => new()
    {
        Fence = _ => Corners,
        OriginalsFile = "originals.json",
    };

    private static SetupRig Writing(MemoryOriginals store, ParameterServer? server = null) => new(
        server ?? SetupRig.Ardupilot(),
        new AutopilotSetupOptions { SetsFailsafes = true, OriginalsFile = "originals.json" }, store);
}
