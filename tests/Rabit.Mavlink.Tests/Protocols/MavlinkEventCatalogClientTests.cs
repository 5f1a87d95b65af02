using System;
using System.Text;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

public class MavlinkEventCatalogClientTests
{
    private const string General = """
        {"version": 1, "metadataTypes": [
          {"type": 1, "uri": "mftp://etc/parameters.json"},
          {"type": 4, "uri": "mftp://[;comp=1]etc/extras/all_events.json", "uriFallback": "https://px4.io/x"}
        ]}
        """;

    private const string Events = """
        {"version": 2, "components": {"1": {"namespace": "px4", "event_groups": {"default": {"events": {
          "100": {"name": "landed", "message": "Landed"}
        }}}}}}
        """;

    [Theory]
    [InlineData(0)]
    [InlineData(20)]
    public void Fetch_FilesOfTheAutopilot_Catalog(int lossPercent)
    {
        for (ulong seed = 1; seed <= 10; seed++)
        {
            var vehicle = new MetadataVehicle("mftp:///etc/extras/general.json");
            vehicle.Set("etc/extras/general.json", General);
            vehicle.Set("etc/extras/all_events.json", Events + new string(' ', 5000));
            MavlinkEventCatalogClient client = Run(vehicle, lossPercent, seed);
            if (lossPercent > 0 && client.Failure is not null)
                continue;   // three requests may all be lost
            Assert.Equal("Landed", client.Catalog!.Find(0x0100_0064)!.Message);
        }
    }

    [Fact]
    public void Fetch_AutopilotWithoutMetadata_SaysSoAndMayBeginAgain()
    {
        var vehicle = new MetadataVehicle(null);
        MavlinkEventCatalogClient client = Run(vehicle, 0, 1);
        Assert.Equal("the autopilot does not say where its metadata are", client.Failure);
        Assert.Null(client.Catalog);
        client.Start(TimeSpan.FromSeconds(500));
        Assert.Null(client.Failure);
        Assert.True(client.IsBusy && client.TryTakeFrame(TimeSpan.FromSeconds(500), out _));
    }

    [Theory]
    [InlineData("https://px4.io/general.json", null, "is no file of its own")]
    [InlineData("mftp://", null, "which is no file")]
    [InlineData("mftp:///missing.json", null, "metadata cannot be read: ")]
    [InlineData("mftp:///general.json", "[]", "name no file of events")]
    [InlineData("mftp:///general.json", "{", "the autopilot's metadata: ")]
    [InlineData("mftp:///general.json", "{\"metadataTypes\": [1, {\"type\": \"4\"}, {\"type\": 4}]}", "name no file")]
    [InlineData(
        "mftp:///general.json", "{\"metadataTypes\": [{\"type\": 4, \"uri\": \"http://x\"}]}", "no file of its own")]
    [InlineData(
        "mftp:///general.json", "{\"metadataTypes\": [{\"type\": 4, \"uri\": \"mftp://general.json\"}]}", "version")]
    public void Fetch_WhatCannotBeUsed_SaysWhy(string uri, string? general, string why)
    {
        var vehicle = new MetadataVehicle(uri);
        if (general is not null)
            vehicle.Set("general.json", general);
        MavlinkEventCatalogClient client = Run(vehicle, 0, 1);
        Assert.Contains(why, client.Failure, StringComparison.Ordinal);
        Assert.Null(client.Catalog);
    }

    // As PX4's own builds have it.
    [Fact]
    public void Fetch_CompressedFile_SaysSo()
    {
        var vehicle = new MetadataVehicle("mftp:///general.json.xz");
        vehicle.Files.Set("general.json.xz", new byte[] { 0xFD, 0x37, 0x7A, 0x58, 0x5A, 0x00, 0x00, 0x04 });
        Assert.Equal("the autopilot's metadata is compressed with xz", Run(vehicle, 0, 1).Failure);
    }

    private static MavlinkEventCatalogClient Run(MetadataVehicle vehicle, int lossPercent, ulong seed)
    {
        var world = new ProtocolWorld(vehicle, lossPercent, seed);
        var client = new MavlinkEventCatalogClient(ScriptedVehicle.Companion(), ScriptedVehicle.Address);
        client.Start(world.Now);
        bool ended = world.RunUntil(
            () => !client.IsBusy, client.Handle, client.TryTakeFrame, () => client.NextDue,
            TimeSpan.FromSeconds(300));
        Assert.True(ended, world.Context);
        return client;
    }

    private sealed class MetadataVehicle(string? uri) : ScriptedVehicle
    {
        private MavlinkFtpServer? _server;

        public MavlinkMemoryFiles Files { get; } = new();

        public override TimeSpan NextDue => Server.NextDue;

        private MavlinkFtpServer Server => _server ??= new MavlinkFtpServer(Sender, Files);

        public void Set(string path, string text) => Files.Set(path, Encoding.UTF8.GetBytes(text));

        public override void Handle(in MavlinkFrame frame, TimeSpan now)
        {
            Server.Handle(frame, now);
            if (uri is not null && frame.TryDecode(out CommandLong command)
                && command.Command == MavCmd.RequestMessage
                && command.Param1.Equals((float)ComponentMetadata.MavlinkId))
                Send(new ComponentMetadata { Uri = new Text100(uri) });
        }

        public override void Tick(TimeSpan now)
        {
            while (Server.TryTakeFrame(now, out MavlinkFrame frame))
                Send(frame);
        }
    }
}
