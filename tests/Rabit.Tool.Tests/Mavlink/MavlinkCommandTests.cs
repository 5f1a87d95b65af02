using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Tests.Framing;
using Rabit.Mavlink.Tests.Logs;
using Spectre.Console;
using Xunit;

namespace Rabit.Tool.Tests.Mavlink;

/// <summary><c>rabit mavlink</c> on small logs: what is lost, unknown, damaged or asked for wrongly.</summary>
public sealed class MavlinkCommandTests : IDisposable
{
    private readonly string _folder = Path.Combine(Path.GetTempPath(), "rabit-dump-" + Guid.NewGuid().ToString("N"));
    private readonly string _log;

    public MavlinkCommandTests()
    {
        Directory.CreateDirectory(_folder);
        _log = Path.Combine(_folder, "a log.tlog");
    }

    [Theory]
    [InlineData("--bogus FILE", "'--bogus' is no option.")]
    [InlineData("FILE --cvs", "'--cvs' is no option; did you mean '--csv'?")]
    [InlineData("", "FILE")]
    [InlineData("FILE two", "'two'")]
    [InlineData("FILE --message NO_SUCH", "--message NO_SUCH: no message of that name. (")]
    [InlineData("FILE --message STATUSTEX", "no message of that name; did you mean STATUSTEXT? (")]
    [InlineData("FILE --message 16777216", "--message 16777216: no message of that name.")]
    [InlineData("FILE --csv", "--csv needs exactly one --message")]
    [InlineData("FILE --csv -m ATTITUDE -m HEARTBEAT", "--csv needs exactly one --message")]
    [InlineData("FILE --csv -m 11259375", "message 11259375 is in no definition")]
    [InlineData("FILE --csv --json -m ATTITUDE", "exclude each other")]
    [InlineData("FILE --system 0", "--system 0: it must be a number from 1 to 255.")]
    [InlineData("FILE --component 256", "--component 256: it must be a number from 1 to 255.")]
    [InlineData("FILE --print --px4-events /nowhere/e.json", "--px4-events /nowhere/e.json: ")]
    [InlineData("FILE --json --px4-events FILE", "a log.tlog: no JSON: ")]
    [InlineData("/nowhere/a.tlog", "/nowhere/a.tlog: no such file.")]
    [InlineData("/proc/self/mem", "/proc/self/mem: ")]
    public void CommandLine_BadInput_IsOneLineAndExitCode2(string arguments, string expected)
    {
        Save(new LogBuilder().Record(LogBuilder.Start));
        AssertRefused(expected, arguments.Split([' '], StringSplitOptions.RemoveEmptyEntries)
            .Select(argument => argument == "FILE" ? _log : argument).ToArray());
    }

    [Fact]
    public void File_FolderEmptyOrNoLog_SaysSo()
    {
        AssertRefused($"{_folder}: that is a folder.", _folder);
        File.WriteAllText(_log, "");
        AssertRefused($"{_log}: the file is empty.", _log);
        File.WriteAllText(_log, string.Concat(Enumerable.Repeat("This is prose, not a log.\n", 500)));
        AssertRefused($"{_log}: no intact record in it: it is no telemetry log.", _log, "--json");
    }

    [Fact]
    public void Message_NotInTheLog_IsExitCode1()
    {
        Save(new LogBuilder().Record(LogBuilder.Start).Record(LogBuilder.Start + 1));
        ToolProcess dump = Dump(_log, "--message", "ATTITUDE");
        Assert.Equal(1, dump.ExitCode);
        Assert.Empty(dump.Output);
        Assert.Equal(
            $"rabit mavlink: {_log}: none of its 2 records is what was asked for.", Assert.Single(dump.Errors));
    }

    [Fact]
    public void Table_GapsInTheSequence_AreLossOfTheirSender()
    {
        var log = new LogBuilder();
        for (int sequence = 0; sequence < 40; sequence++)
        {
            if (sequence % 4 != 3)
                log.Record(LogBuilder.Start + (sequence * 100_000), Wire.Of(default(Heartbeat), (byte)sequence));
        }

        Save(log);
        ToolProcess dump = Dump(_log);
        string[] sender = dump.Output[2].Split([' '], StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(["30", "9", "23.08", "0"], new[]
        {
            sender[sender.Length - 5], sender[sender.Length - 3], sender[sender.Length - 2], sender[sender.Length - 1]
        });
        Assert.Contains("30     7.63", dump.Output[4]);
    }

    [Fact]
    public void Damage_IsReportedAndTheRestIsShown()
    {
        byte[] garbage = Encoding.ASCII.GetBytes("noise");
        LogBuilder log = new LogBuilder().Record(LogBuilder.Start);
        long damage = log.Length;
        Save(log.Raw(garbage).Record(LogBuilder.Start + 1).Record(LogBuilder.Start + 2));

        ToolProcess table = Dump(_log);
        Assert.Equal(0, table.ExitCode);
        Assert.Equal($"damage: 5 bytes belong to no intact record, the first at offset {damage}", table.Output[1]);

        ToolProcess lines = Dump(_log, "--print");
        Assert.Equal((0, 3), (lines.ExitCode, lines.Output.Count));
        Assert.Contains(
            $"5 bytes belong to no intact record, the first at offset {damage}", Assert.Single(lines.Errors));
    }

    [Fact]
    public void UnknownMessage_IsShownWithItsBytes()
    {
        const string Name = "UNKNOWN_11259375";
        Save(new LogBuilder()
            .Record(LogBuilder.Start, Wire.Of(default(Heartbeat), 0))
            .Record(LogBuilder.Start + 1, Wire.V2(Wire.UnknownId, [1, 0xAB], sequence: 1))
            .Record(LogBuilder.Start + 2, Wire.Of(default(Heartbeat), 2)));

        Assert.Contains(
            Dump(_log).Output, line => line.StartsWith(Name + "  11259375", StringComparison.Ordinal));
        Assert.EndsWith(
            Name + " 01ab", Assert.Single(Dump(_log, "-m", "11259375").Output), StringComparison.Ordinal);
        Assert.EndsWith(
            $"\"message\":\"{Name}\",\"payload\":\"01ab\"}}",
            Assert.Single(Dump(_log, "-m", "11259375", "--json").Output), StringComparison.Ordinal);
    }

    [Fact]
    public void Texts_QuotesAndControlCharacters_AreHarmless()
    {
        var status = new Statustext { Severity = MavSeverity.Error, Text = new Text50("say \"a,b\"\u001b[2J") };
        Save(new LogBuilder().Record(LogBuilder.Start, Wire.Of(status)));
        Assert.Contains("text=\"say \"a,b\".[2J\"", Dump(_log, "--print").Output[0]);
        Assert.Contains(
            ",3,\"say \"\"a,b\"\"\u001b[2J\",0,0", Dump(_log, "-m", "STATUSTEXT", "--csv").Output[1]);
        Assert.Contains("\\u001B[2J", Dump(_log, "--json").Output[0]);
    }

    [Fact]
    public void Json_NotANumber_IsNull()
    {
        var attitude = new Attitude { Roll = float.NaN, Pitch = float.NegativeInfinity, Yaw = 0.1f };
        Save(new LogBuilder().Record(LogBuilder.Start, Wire.Of(attitude)));
        Assert.Contains("\"roll\":null,\"pitch\":null,\"yaw\":0.1,", Dump(_log, "--json").Output[0]);
        Assert.Contains(",0,NaN,-Infinity,0.1,", Dump(_log, "--csv", "-m", "ATTITUDE").Output[1]);
    }

    [Fact]
    public void ProgressBar_InATerminal_ShowsHowFarItIs()
    {
        var screen = new StringWriter(CultureInfo.InvariantCulture);
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = AnsiSupport.Yes,
            Interactive = InteractionSupport.Yes,
            ColorSystem = ColorSystemSupport.NoColors,
            Out = new AnsiConsoleOutput(screen),
        });
        using (var progress = new ProgressBar(console, 200))
            progress.Show(100);
        Assert.Contains("reading", screen.ToString());
        Assert.Contains("%", screen.ToString());
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    private void Save(LogBuilder log) => File.WriteAllBytes(_log, log.ToArray());

    private static ToolProcess Dump(params string[] arguments) => ToolProcess.Run(["mavlink", .. arguments]);

    private static void AssertRefused(string expected, params string[] arguments)
    {
        ToolProcess dump = Dump(arguments);
        string line = Assert.Single(dump.Errors);
        Assert.StartsWith("rabit mavlink: ", line, StringComparison.Ordinal);
        Assert.Contains(expected, line);
        Assert.Equal((2, 0), (dump.ExitCode, dump.Output.Count));
    }
}
