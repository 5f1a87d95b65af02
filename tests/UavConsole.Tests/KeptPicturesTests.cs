using System;
using System.IO;
using System.Linq;
using Rabit.Vision;
using Xunit;

namespace UavConsole.Tests;

/// <summary>The pictures that a flight keeps.</summary>
public sealed class KeptPicturesTests : IDisposable
{
    private readonly string _folder = Directory.CreateDirectory(
        Path.Combine(Path.GetTempPath(), $"rabit-keep-{Guid.NewGuid():N}")).FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Flight_KeepsAll_EachSaysWhereItWasTaken()
    {
        string mission = SmallMission.WriteTo(_folder);
        using ConsoleProcess process = ConsoleProcess.RunIn(
            _folder, out _, "--headless", "--mission", mission, "--targets", "0", "--keep-pictures", "kept",
            "--keep-all-pictures");

        string[] files = Directory.GetFiles(Path.Combine(_folder, "kept"));
        Assert.InRange(files.Length, 5, 100);
        Assert.Contains($"kept pictures: {files.Length} in {Path.Combine(_folder, "kept")}", process.Output);
        foreach (PhotoMetadata said in files.Select(f => PhotoMetadata.Read(File.ReadAllBytes(f), f)))
        {
            Assert.Empty(said.Faults);
            Assert.InRange(said.LatitudeDegrees!.Value, 47.3970, 47.3976);
            Assert.InRange(said.LongitudeDegrees!.Value, 8.5444, 8.5452);
            Assert.InRange(said.RelativeAltitudeMetres!.Value, 15, 25);
            Assert.InRange(said.GimbalPitchDegrees!.Value, -90, -60);
        }
    }

    [Theory]
    [InlineData("--keep-all-pictures needs --keep-pictures DIR.", "--keep-all-pictures")]
    [InlineData("--keep-pictures needs a camera: what is played has no pictures.", "--link", "tlog:a.tlog", "--keep-pictures", "x")]
    [InlineData("--keep-pictures is for one vehicle", "--vehicles", "3", "--keep-pictures", "x")]
    [InlineData("the folder of the kept pictures, /proc/nowhere, cannot be written", "--keep-pictures", "/proc/nowhere")]
    public void Options_ThatCannotBe_AreNamed(string expected, params string[] arguments)
        => Assert.Contains(expected, Assert.Single(CommandLineRun.Refuse(["--headless", .. arguments])));
}
