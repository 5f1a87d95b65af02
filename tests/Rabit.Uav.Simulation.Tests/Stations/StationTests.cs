using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Stations;

/// <summary>What stock ground stations ask first, of both simulated autopilots.</summary>
public class StationTests
{
    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void Ping_OfAll_IsAnsweredToTheAsker(SimulatedAutopilot autopilot)
    {
        using Ground ground = Start(autopilot);
        ground.Send(new Ping { TimeUsec = 1234, Seq = 9 });
        ground.Send(new Ping { TimeUsec = 1, Seq = 1, TargetSystem = 1, TargetComponent = 1 });
        ground.Run(0.5);
        Ping answer = Assert.Single(ground.All<Ping>()).Message;
        Assert.Equal(
            (1234ul, 9u, (byte)255, (byte)190),
            (answer.TimeUsec, answer.Seq, answer.TargetSystem, answer.TargetComponent));
    }

    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void LogRequestList_NoLogs_OneEntryThatSaysSo(SimulatedAutopilot autopilot)
    {
        using Ground ground = Start(autopilot);
        ground.Send(new LogRequestList { TargetSystem = 1, TargetComponent = 1, End = ushort.MaxValue });
        ground.Run(0.5);
        LogEntry entry = Assert.Single(ground.All<LogEntry>()).Message;
        Assert.Equal((0, 0, 0, 0u), (entry.Id, entry.NumLogs, entry.LastLogNum, entry.Size));
    }

    // The remote control of PX4 is not in use by default.
    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot, 1)]
    [InlineData(SimulatedAutopilot.Px4, 1)]
    [InlineData(SimulatedAutopilot.Px4, 0)]
    public void RcChannelsAndMissionCurrent_AskedFor_Come(SimulatedAutopilot autopilot, int inputMode)
    {
        var options = new SimulationOptions { Autopilot = autopilot };
        if (autopilot == SimulatedAutopilot.Px4)
            options.Parameters = new Dictionary<string, double> { ["COM_RC_IN_MODE"] = inputMode };
        using var ground = new Ground(options);
        ground.Run(0.5);
        Assert.Equal(MavResult.Accepted, ground.Stream(RcChannels.MavlinkId, 2));
        Assert.Equal(MavResult.Accepted, ground.Stream(MissionCurrent.MavlinkId, 2));
        ground.Run(10);
        bool hasRadio = autopilot == SimulatedAutopilot.ArduPilot || inputMode == 0;
        Assert.InRange(ground.Count<RcChannels>(), hasRadio ? 18 : 0, hasRadio ? 21 : 0);
        Assert.InRange(ground.Count<MissionCurrent>(), 18, 22);
        Assert.Equal(0, ground.Last<MissionCurrent>().Seq);
        if (hasRadio)
            Assert.Equal((1500, 254), (ground.Last<RcChannels>().Chan1Raw, ground.Last<RcChannels>().Rssi));
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.RequestMessage, MissionCurrent.MavlinkId));
    }

    [Fact]
    public void RcChannels_RadioIsLost_NoChannels()
    {
        using var ground = new Ground(new SimulationOptions
        {
            Faults = [new ScriptedFault { Kind = ScriptedFaultKind.RcLost, At = TimeSpan.FromSeconds(2) }],
        });
        Assert.Equal(MavResult.Accepted, ground.Stream(RcChannels.MavlinkId, 2));
        ground.Run(5);
        Assert.Equal((0, 0), (ground.Last<RcChannels>().Chancount, ground.Last<RcChannels>().Rssi));
    }

    [Fact]
    public void DataStreams_AsStationsAskForThem_HaveWhatTheirWidgetsShow()
    {
        using var ground = new Ground();
        ground.Send(new RequestDataStream
        {
            TargetSystem = 1,
            TargetComponent = 1,
            ReqStreamId = MavDataStream.All,
            ReqMessageRate = 4,
            StartStop = 1,
        });
        ground.Run(10);
        foreach (int count in new[]
        {
            ground.Count<RcChannels>(), ground.Count<EkfStatusReport>(), ground.Count<MissionCurrent>(),
            ground.Count<SysStatus>(), ground.Count<VfrHud>(),
        })
            Assert.InRange(count, 38, 42);
    }

    [Fact]
    public void AvailableModes_OneOrAll_NamesAndStandardModes()
    {
        using var ground = new Ground();
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.RequestMessage, AvailableModes.MavlinkId, 1));
        ground.Run(0.2);
        AvailableModes first = Assert.Single(ground.All<AvailableModes>()).Message;
        Assert.Equal(("STABILIZE", 1, 9), (first.ModeName.ToString(), first.ModeIndex, first.NumberModes));

        ground.Forget();
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.RequestMessage, AvailableModes.MavlinkId));
        ground.Run(0.2);
        List<AvailableModes> all = ground.All<AvailableModes>().Select(m => m.Message).ToList();
        Assert.Equal(Enumerable.Range(1, 9), all.Select(m => (int)m.ModeIndex));
        AvailableModes rtl = all.Single(m => m.ModeName.ToString() == "RTL");
        Assert.Equal((6u, MavStandardMode.SafeRecovery), (rtl.CustomMode, rtl.StandardMode));
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.RequestMessage, AvailableModes.MavlinkId, 10));
    }

    // The service came with PX4 1.15.
    [Fact]
    public void AvailableModes_OfPx4_AreDenied()
    {
        using Ground ground = Start(SimulatedAutopilot.Px4);
        Assert.Equal(MavResult.Denied, ground.Command(MavCmd.RequestMessage, AvailableModes.MavlinkId, 1));
    }

    // MAVProxy takes a bit that is missing for a breach.
    [Fact]
    public void SysStatus_FenceIsNotBreached_IsHealthy()
    {
        using var ground = new Ground();
        Assert.Equal(MavResult.Accepted, ground.Stream(SysStatus.MavlinkId, 1));
        ground.Run(8);
        Assert.True(ground.Last<SysStatus>().OnboardControlSensorsHealth.HasFlag(MavSysStatusSensor.Geofence));
        Assert.True(ground.Last<SysStatus>().OnboardControlSensorsPresent.HasFlag(MavSysStatusSensor.Geofence));
    }

    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot, false)]
    [InlineData(SimulatedAutopilot.ArduPilot, true)]
    [InlineData(SimulatedAutopilot.Px4, false)]
    public void SystemId_Set_IsThatOfAllItSends(SimulatedAutopilot autopilot, bool newerNames)
    {
        using var ground = new Ground(new SimulationOptions
        {
            Autopilot = autopilot,
            SystemId = 7,
            HasNewerParameterNames = newerNames,
        });
        ground.Run(3);
        ground.Send(new Ping { Seq = 1 });
        ground.Send(new ParamRequestList { TargetSystem = 7, TargetComponent = 1 });
        ground.Send(new LogRequestList { TargetSystem = 1, TargetComponent = 1 });
        ground.Run(2);
        Assert.All(ground.Frames, f => Assert.Equal(7, f.Frame.SystemId));
        Assert.Single(ground.All<Ping>());
        Assert.Empty(ground.All<LogEntry>());
        Assert.Equal(
            newerNames ? "MAV_SYSID" : autopilot == SimulatedAutopilot.Px4 ? "MAV_SYS_ID" : "SYSID_THISMAV",
            ground.All<ParamValue>().Select(v => v.Message).First(v => v.ParamId.ToString().Contains("SYS")
                && !v.ParamId.ToString().Contains("GCS")).ParamId.ToString());
        Assert.Throws<ArgumentException>(() => new SimulatedWorld(new SimulationOptions { SystemId = 255 }));
        Assert.Throws<ArgumentException>(() => new SimulatedWorld(new SimulationOptions { SystemId = 0 }));
    }

    [Theory]
    [InlineData("", 0x671B)]
    [InlineData("?start=10&count=5", 0x671B)]
    [InlineData("?withdefaults=1", 0x671C)]
    public void ParameterFile_ReadByMavlinkFtp_HasTheParametersOfTheList(string query, int magic)
    {
        using var ground = new Ground(new SimulationOptions
        {
            Parameters = new Dictionary<string, double> { ["RTL_ALT"] = 2500, ["WPNAV_SPEED"] = 612.5 },
        });
        ground.Send(new ParamRequestList { TargetSystem = 1, TargetComponent = 1 });
        ground.Run(2);
        List<(string, float)> listed = ground.All<ParamValue>().Where(v => v.Message.ParamIndex != ushort.MaxValue)
            .OrderBy(v => v.Message.ParamIndex).Select(v => (v.Message.ParamId.ToString(), v.Message.Value)).ToList();
        Assert.InRange(listed.Count, 40, 80);

        byte[] file = Read(ground, "@PARAM/param.pck" + query);
        Assert.Equal(magic, BitConverter.ToUInt16(file, 0));
        Assert.Equal(listed.Count, BitConverter.ToUInt16(file, 4));
        List<(string Name, float Value, float? Default)> packed = Unpack(file);
        Assert.Equal(
            query.Contains("start") ? listed.Skip(10).Take(5) : listed, packed.Select(p => (p.Name, p.Value)));
        Assert.Equal(packed.Count, BitConverter.ToUInt16(file, 2));
        Assert.Equal(magic == 0x671C ? 1500 : null, packed.Find(p => p.Name == "RTL_ALT").Default);
    }

    [Theory]
    [InlineData("@PARAM/param.pck?start=9999")]
    [InlineData("@PARAM/param.pck?start=x")]
    [InlineData("@PARAM/param.pck&count=1")]
    [InlineData("@PARAM/other")]
    [InlineData("@SYS/threads.txt")]
    public void ParameterFile_OtherNames_AreNotThere(string path)
    {
        using var ground = new Ground();
        var client = new MavlinkFtpClient(new MavlinkSender(255, 190), new MavlinkAddress(1, 1));
        Assert.True(client.TryStartRead(path, ground.Now));
        Assert.NotEqual(MavlinkFtpStatus.Done, Run(ground, client).Status);
    }

    private static Ground Start(SimulatedAutopilot autopilot)
    {
        var ground = new Ground(new SimulationOptions { Autopilot = autopilot });
        ground.Run(0.5);
        return ground;
    }

    private static byte[] Read(Ground ground, string path)
    {
        var client = new MavlinkFtpClient(new MavlinkSender(255, 190), new MavlinkAddress(1, 1));
        Assert.True(client.TryStartRead(path, ground.Now));
        Assert.Equal(MavlinkFtpStatus.Done, Run(ground, client).Status);
        return client.Content.ToArray();
    }

    private static MavlinkFtpOutcome Run(Ground ground, MavlinkFtpClient client)
    {
        int known = ground.Frames.Count;
        for (int step = 0; step < 2000; step++)
        {
            while (client.TryTakeFrame(ground.Now, out MavlinkFrame frame))
            {
                Assert.True(frame.TryDecode(out FileTransferProtocol request));
                ground.Send(request);
            }

            ground.Run(0.01);
            for (; known < ground.Frames.Count; known++)
                client.Handle(ground.Frames[known].Frame, ground.Now);
            if (client.TryTakeOutcome(out MavlinkFtpOutcome outcome))
                return outcome;
        }

        throw new Xunit.Sdk.XunitException("no outcome");
    }

    // By ArduPilot's description of the format (AP_Filesystem/README.md); no value lies across two packets.
    private static List<(string Name, float Value, float? Default)> Unpack(byte[] file)
    {
        var all = new List<(string, float, float?)>();
        string name = "";
        for (int at = 6; at < file.Length;)
        {
            if (file[at] == 0)
            {
                at++;
                continue;
            }

            int type = file[at] & 15;
            bool hasDefault = (file[at] & 16) != 0;
            int common = file[at + 1] & 15;
            int rest = (file[at + 1] >> 4) + 1;
            name = common < name.Length ? name.Remove(common) : name;
            name += Encoding.ASCII.GetString(file, at + 2, rest);
            at += 2 + rest;
            int length = new[] { 0, 1, 2, 4, 4 }[type];
            float value = Number(file, ref at, type);
            float? standard = hasDefault ? Number(file, ref at, type) : null;
            Assert.True((at - 1) / 239 == (at - length) / 239, $"{name} ends at {at}");
            all.Add((name, value, standard));
        }

        return all;
    }

    private static float Number(byte[] file, ref int at, int type)
    {
        int start = at;
        at += new[] { 0, 1, 2, 4, 4 }[type];
        return type switch
        {
            1 => (sbyte)file[start],
            2 => BitConverter.ToInt16(file, start),
            3 => BitConverter.ToInt32(file, start),
            _ => BitConverter.ToSingle(file, start),
        };
    }
}
