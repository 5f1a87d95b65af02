using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Rabit.Uav.Tests.Communications;
using Xunit;

namespace UavConsole.Tests.Output;

/// <summary>
/// Files of a run on a disk that is full: complete or absent, the one before them kept, the loss reported.
/// </summary>
public sealed class OutputFileTests : IDisposable
{
    private static readonly byte[] Content = [.. Enumerable.Repeat((byte)'x', 10_000)];

    private readonly TestLog _folder = new();

    private string SummaryPath => Path.Combine(_folder.Folder, "s.json");

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Write_DiskFull_LeavesNothingAndKeepsWhatWasThere(bool wasThere)
    {
        if (wasThere)
            File.WriteAllText(SummaryPath, "the last flight");
        WholeFile file = Whole();
        LinkToFullDisk(SummaryPath + ".new");

        string? failure = file.Write(Content);

        Assert.StartsWith($"--summary {SummaryPath} cannot be written: ", failure, StringComparison.Ordinal);
        Assert.Equal(wasThere ? [SummaryPath] : [], Directory.GetFiles(_folder.Folder, "s.*"));
        if (wasThere)
            Assert.Equal("the last flight", File.ReadAllText(SummaryPath));
    }

    [Fact]
    public void Write_FileIsThere_IsKeptUnderItsDate()
    {
        File.WriteAllText(SummaryPath, "the last flight");

        Assert.Null(Whole().Write(Content));

        Assert.Equal(Content, File.ReadAllBytes(SummaryPath));
        string kept = Assert.Single(Directory.GetFiles(_folder.Folder, "s.2*.json"));
        Assert.Equal("the last flight", File.ReadAllText(kept));
        Assert.Equal(2, Directory.GetFiles(_folder.Folder, "s.*").Length);
    }

    [Fact]
    public void KeepCopy_StartsThatDoNotFly_LeaveTheFileAndOneCopy()
    {
        File.WriteAllText(SummaryPath, "the last flight");

        DatedFile.KeepCopy(SummaryPath);
        DatedFile.KeepCopy(SummaryPath);

        Assert.Equal("the last flight", File.ReadAllText(SummaryPath));
        string kept = Assert.Single(Directory.GetFiles(_folder.Folder, "s.2*.json"));
        Assert.Equal("the last flight", File.ReadAllText(kept));
    }

    [Fact]
    public void Keep_Device_IsLeftAlone()
    {
        DatedFile.Keep("/dev/full");
        DatedFile.KeepCopy("/dev/full");
        Assert.True(File.Exists("/dev/full"));
    }

    // A run that is killed leaves nothing half: what will be written is not there before.
    [Fact]
    public void Check_NothingThere_LeavesNothing()
    {
        Whole();

        Assert.Empty(Directory.GetFiles(_folder.Folder, "s.*"));
    }

    [Fact]
    public void WriteLine_DiskFull_CountsWhatIsLost()
    {
        using var log = new LogFile(OutputPath.Check("--log", "/dev/full", [])!);
        Assert.Null(log.Loss);

        for (int i = 0; i < 3; i++)
            log.WriteLine("a line");

        Assert.StartsWith("--log /dev/full cannot be written: ", log.Loss, StringComparison.Ordinal);
        Assert.EndsWith("(3 lines were lost)", log.Loss, StringComparison.Ordinal);
    }

    public void Dispose() => _folder.Dispose();

    private WholeFile Whole() => new(OutputPath.Check("--summary", SummaryPath, [])!);

    private static void LinkToFullDisk(string path)
    {
        using Process link = Process.Start("ln", $"-s /dev/full {path}")!;
        link.WaitForExit();
        Assert.Equal(0, link.ExitCode);
    }
}
