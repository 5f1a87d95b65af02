using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Tests;
using Xunit;

namespace Rabit.Tool.Tests.Mavlink;

/// <summary>
/// What <c>rabit mavlink</c> prints of the recorded flights, against the facts listed beside them and against the typed
/// messages.
/// </summary>
public class RecordedFlightTests
{
    private static readonly string Flight = TestData.PathOf("ardupilot-flight.tlog");

    [Theory]
    [InlineData("ardupilot-flight")]
    [InlineData("px4-flight")]
    public void Table_RecordedFlight_AgreesWithItsSidecar(string name)
    {
        using JsonDocument sidecar = TestData.Json(TestData.PathOf(name + ".json"));
        JsonElement facts = sidecar.RootElement;
        ToolProcess dump = ToolProcess.Run("mavlink", TestData.PathOf(name + ".tlog"));

        Assert.Equal((0, 0), (dump.ExitCode, dump.Errors.Count));
        Assert.Contains($"{facts.GetProperty("records")} records, {facts.GetProperty("bytes")} bytes", dump.Output[0]);
        List<string[]> rows = dump.Output.Select(Cells).ToList();
        int messages = rows.FindIndex(cells => cells[0] == "message");
        IEnumerable<string> expected = facts.GetProperty("counts").EnumerateArray()
            .GroupBy(row => $"{row[1]} {row[2]}/{row[3]}", StringComparer.Ordinal)
            .Select(same => $"{same.Key}: {same.Sum(row => row[6].GetInt64())}");
        Assert.Equal(
            Sorted(expected), Sorted(rows.Skip(messages + 1).Select(cells => $"{cells[1]} {cells[2]}: {cells[3]}")));
        IEnumerable<string> senders = facts.GetProperty("sequence").EnumerateArray()
            .Select(row => $"{row.GetProperty("sysid")}/{row.GetProperty("compid")} {row.GetProperty("frames")} "
                + $"{row.GetProperty("missing")} {row.GetProperty("out_of_order")}");
        Assert.Equal(
            Sorted(senders),
            Sorted(rows.Skip(2).Take(messages - 2).Select(
                cells => $"{cells[0]} {cells[cells.Length - 5]} {cells[cells.Length - 3]} {cells[cells.Length - 1]}")));
    }

    [Fact]
    public void Csv_Attitude_HasEveryRecordAndItsValues()
    {
        ToolProcess dump = ToolProcess.Run("mavlink", Flight, "--message", "attitude", "--csv");
        Assert.Equal(0, dump.ExitCode);
        Assert.Equal(
            "time,system,component,sequence,time_boot_ms,roll,pitch,yaw,rollspeed,pitchspeed,yawspeed", dump.Output[0]);

        int row = 0;
        using FileStream file = File.OpenRead(Flight);
        var log = new TlogReader(file, MavlinkDialect.All);
        while (log.TryRead(out MavlinkFrame frame, out TlogRecord record))
        {
            if (!frame.TryDecode(out Attitude attitude))
                continue;
            string[] cells = dump.Output[++row].Split(',');
            Assert.Equal(
                record.TimeUtc, DateTime.Parse(cells[0], CultureInfo.InvariantCulture, DateTimeStyles.RoundtripKind));
            Assert.Equal(
                $"{frame.SystemId},{frame.ComponentId},{frame.Sequence},{attitude.TimeBootMs}",
                string.Join(",", cells.Skip(1).Take(4)));
            Assert.Equal(attitude.Roll, float.Parse(cells[5], CultureInfo.InvariantCulture));
            Assert.Equal(attitude.Yawspeed, float.Parse(cells[10], CultureInfo.InvariantCulture));
        }

        Assert.Equal(row + 1, dump.Output.Count);
        Assert.True(row > 100);
    }

    [Fact]
    public void Json_AllMessages_AreObjectsALine()
    {
        ToolProcess dump = ToolProcess.Run("mavlink", Flight, "--json", "--component", "191");
        Assert.Equal(0, dump.ExitCode);
        foreach (string line in dump.Output)
        {
            using JsonDocument document = JsonDocument.Parse(line);
            Assert.Equal(191, document.RootElement.GetProperty("component").GetInt32());
            Assert.Equal(JsonValueKind.Object, document.RootElement.GetProperty("fields").ValueKind);
        }

        Assert.Contains(
            dump.Output, line => line.Contains("\"message\":\"COMMAND_LONG\",\"fields\":{\"target_system\":1,"));
    }

    [Fact]
    public void Lines_SeveralMessages_NameEnumsAndUnits()
    {
        ToolProcess dump = ToolProcess.Run("mavlink", Flight, "-m", "HEARTBEAT", "-m", "30", "--system", "1", "--component", "1");
        Assert.Equal(0, dump.ExitCode);
        Assert.Contains(
            dump.Output,
            line => line.Contains("  1/1  HEARTBEAT type=MAV_TYPE_QUADROTOR, autopilot=MAV_AUTOPILOT_ARDUPILOTMEGA, "));
        Assert.Contains(dump.Output, line => line.Contains("  1/1  ATTITUDE time_boot_ms="));
        Assert.All(dump.Output, line => Assert.True(line.Contains(" HEARTBEAT ") || line.Contains(" ATTITUDE ")));
    }

    private static string[] Cells(string line) => line.Split([' '], StringSplitOptions.RemoveEmptyEntries);

    private static List<string> Sorted(IEnumerable<string> lines)
        => lines.OrderBy(line => line, StringComparer.Ordinal).ToList();

    // By the ids of the recorded PX4: 26622124 is that of the landing.
    [Theory]
    [InlineData("--print", "[0, 0, 0, 0")]
    [InlineData("--json", "\"text\":\"Landing detected")]
    public void EventsOfPx4_MetadataGiven_TheirTextsBesideTheFields(string option, string shown)
    {
        string metadata = Path.Combine(Path.GetTempPath(), $"rabit-events-{Guid.NewGuid():N}.json");
        File.WriteAllText(
            metadata,
            """
            {"version": 2, "components": {"1": {"namespace": "px4", "event_groups": {"default": {"events": {
              "9844908": {"name": "landing", "message": "Landing detected"}}}}}}}
            """);
        ToolProcess dump = ToolProcess.Run("mavlink", TestData.PathOf("px4-flight.tlog"), option, "--message", "EVENT", "--px4-events", metadata);
        File.Delete(metadata);
        Assert.Equal(0, dump.ExitCode);
        string landing = Assert.Single(
            dump.Output, line => line.Contains("Landing detected", StringComparison.Ordinal));
        Assert.Contains("26622124", landing, StringComparison.Ordinal);
        Assert.Contains(shown, landing, StringComparison.Ordinal);
    }
}
