using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>What the vehicle has to say: texts of several messages, and events of PX4.</summary>
public class TextAndEventTests
{
    private const string Metadata = """
        {"version": 2, "components": {"1": {"namespace": "px4", "event_groups": {"default": {"events": {
          "100": {"name": "low", "message": "Low battery: {1:.1} V", "arguments": [{"type": "float", "name": "v"}]}
        }}}}}}
        """;

    [Fact]
    public void Text_InChunks_IsOneText()
    {
        using AutopilotRig rig = MakeRig();
        List<Statustext> chunks = Split(new string('x', 70) + " \u20AC");
        rig.Send(chunks[0]);
        rig.Run(0.1);
        Assert.Empty(Texts(rig));
        rig.Send(chunks[1]);
        rig.Run(0.1);
        Assert.Equal([new string('x', 70) + " \u20AC"], Texts(rig));
    }

    [Fact]
    public void Text_ChunkIsLost_ComesAfterASecondWithAGap()
    {
        using AutopilotRig rig = MakeRig();
        rig.Send(Split(new string('x', 70))[0]);
        rig.Send(new Statustext { Text = new Text50("alone"), Severity = MavSeverity.Info });
        rig.Run(0.7);
        Assert.Equal(["alone"], Texts(rig));
        rig.Run(1);
        Assert.Equal(["alone", new string('x', 50) + "\u2026"], Texts(rig));
    }

    [Fact]
    public void Event_OfWhichTheTextIsKnown_IsAText()
    {
        using AutopilotRig rig = MakeRig(MavlinkEventCatalog.Parse(Encoding.UTF8.GetBytes(Metadata)));
        Event happened = Happened(7, 0x0100_0064, level: 4);
        rig.Send(happened);
        rig.Send(happened);
        rig.Send(Happened(8, 0x0100_0064, level: 8));   // between programs
        rig.Send(Happened(9, 0x0100_0065, level: 4));   // not known: a line of the log

        // PX4 marks texts of events by a tab where a ground station is connected.
        rig.Send(new Statustext { Text = new Text50("Low battery\t"), Severity = MavSeverity.Warning });
        rig.Run(0.1);
        Assert.Equal(["Low battery: 10.5 V"], Texts(rig));
        Assert.Equal(MavSeverity.Warning, rig.Texts.Newest!.Severity);
    }

    [Fact]
    public void Event_IsMissing_IsAskedForAndComesLate()
    {
        using AutopilotRig rig = MakeRig(MavlinkEventCatalog.Parse(Encoding.UTF8.GetBytes(Metadata)));
        rig.Send(Happened(7, 0x0100_0064, level: 4));
        rig.Send(Happened(9, 0x0100_0064, level: 4));
        rig.Run(1);
        RequestEvent asked = rig.Sink.MessagesOf<RequestEvent>()[0];
        Assert.Equal(
            (8, 8, 1, 1), (asked.FirstSequence, asked.LastSequence, asked.TargetSystem, asked.TargetComponent));
        rig.Send(Happened(8, 0x0100_0064, level: 4));
        rig.Run(2);
        Assert.Equal(3, Texts(rig).Count());
        Assert.InRange(rig.Sink.MessagesOf<RequestEvent>().Count, 1, 3);
    }

    [Fact]
    public void Event_TextsAreToBeFetched_FetchedByMavlinkFtp()
    {
        var options = new AutopilotOptions { RequestedRates = [], FetchesEventCatalog = true };
        using var rig = new AutopilotRig(options);
        var vehicle = new MavlinkSender(1, 1);
        var files = new MavlinkMemoryFiles();
        files.Set("events.json", Encoding.UTF8.GetBytes(Metadata));
        files.Set("general.json", Encoding.UTF8.GetBytes(
            "{\"metadataTypes\": [{\"type\": 4, \"uri\": \"mftp://events.json\"}]}"));
        var server = new MavlinkFtpServer(vehicle, files);
        int known = 0;
        for (int step = 0; step < 100; step++)
        {
            if (step % 10 == 0)
                rig.Send(AutopilotRig.Copter());
            rig.Run(0.1);
            for (; known < rig.Sink.Frames.Count; known++)
            {
                MavlinkFrame sent = rig.Sink.Frames[known].Frame;
                server.Handle(sent, rig.Reactor.Now);
                if (sent.TryDecode(out CommandLong command) && command.Param1.Equals(397f))
                    rig.Send(new ComponentMetadata { Uri = new Text100("mftp:///general.json") });
            }

            while (server.TryTakeFrame(rig.Reactor.Now, out MavlinkFrame answer))
            {
                Assert.True(answer.TryDecode(out FileTransferProtocol file));
                rig.Send(file);
            }
        }

        rig.Send(Happened(1, 0x0100_0064, level: 4));
        rig.Run(0.1);
        Assert.Equal(["Low battery: 10.5 V"], Texts(rig));
    }

    private static AutopilotRig MakeRig(MavlinkEventCatalog? catalog = null)
    {
        var rig = new AutopilotRig(new AutopilotOptions { RequestedRates = [], EventCatalog = catalog });
        rig.Beat(1);
        return rig;
    }

    private static IEnumerable<string> Texts(AutopilotRig rig) => rig.Texts.Select(t => t.Text).Reverse();

    private static Event Happened(ushort sequence, uint id, byte level) => new()
    {
        Id = id,
        Sequence = sequence,
        LogLevels = level,
        EventTimeBootMs = 1000u + sequence,
        Arguments = new ByteArray40(BitConverter.GetBytes(10.5f)),
    };

    private static List<Statustext> Split(string text)
    {
        var chunks = new List<Statustext>();
        var splitter = new MavlinkStatusTextSplitter();
        splitter.Start(MavSeverity.Warning, text);
        while (splitter.TryNext(out Statustext chunk))
            chunks.Add(chunk);
        return chunks;
    }
}
