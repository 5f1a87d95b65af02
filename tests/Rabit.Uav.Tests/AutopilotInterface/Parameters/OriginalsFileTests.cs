using System;
using System.IO;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface.Parameters;

/// <summary>
/// The file of the autopilot's own values: complete or unchanged, and refused by name where it is damaged.
/// </summary>
public sealed class OriginalsFileTests : IDisposable
{
    private readonly string _folder = Directory.CreateDirectory(
        System.IO.Path.Combine(System.IO.Path.GetTempPath(), "rabit-" + Guid.NewGuid().ToString("N"))).FullName;

    private string Path => System.IO.Path.Combine(_folder, "originals.json");

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Save_ThenLoad_IsTheSame()
    {
        var file = new OriginalsFile(Path);
        var originals = new Originals(
            3,
            [
                new AutopilotParameter("BATT_LOW_VOLT", 10.8000001907348633, MavParamType.Real32),
                new AutopilotParameter("FS_OPTIONS", 20, MavParamType.Int32),
            ],
            [
                new FenceItem(
                    MavCmd.NavFenceCircleInclusion, MavFrame.Global, 60, 0, 0, 0, 473977000, -85456000, 1.5f),
            ]);

        Assert.Null(file.Save(originals));
        Assert.Null(file.Save(originals));
        Assert.Null(file.Load(out Originals? loaded));

        Assert.Equal(3, loaded!.SystemId);
        Assert.Equal(originals.Parameters, loaded.Parameters);
        Assert.Equal(originals.Fence, loaded.Fence);
        Assert.Equal(["originals.json"], Directory.GetFiles(_folder).Select(System.IO.Path.GetFileName));
    }

    [Fact]
    public void Load_NoFile_IsNothingAndNoFault()
    {
        Assert.Null(new OriginalsFile(Path).Load(out Originals? originals));
        Assert.Null(originals);
    }

    [Theory]
    [InlineData("{ \"version\": 1, \"systemId\": 1, \"param", "is damaged")]
    [InlineData("[]", "it is no file of original parameters")]
    [InlineData("{ \"version\": 2, \"systemId\": 1, \"parameters\": [] }", "version is 2; this program reads 1")]
    [InlineData("{ \"version\": 1, \"systemId\": 300, \"parameters\": [] }", "systemId is 300; it must be 1 to 255")]
    [InlineData("{ \"version\": 1, \"systemId\": 1 }", "parameters")]
    [InlineData("{ \"version\": 1, \"systemId\": 1, \"parameters\": [3] }", "an element that is no object")]
    [InlineData("{ \"version\": 1, \"systemId\": 1, \"parameters\": [{ \"type\": 9, \"value\": 1 }] }",
        "without a name")]
    [InlineData("{ \"version\": 1, \"systemId\": 1, \"parameters\": [], \"fence\": [[1, 2]] }",
        "an element that is no item of a fence")]
    public void Load_DamagedFile_IsRefusedByName(string content, string expected)
    {
        File.WriteAllText(Path, content);

        string? fault = new OriginalsFile(Path).Load(out Originals? originals);

        Assert.Null(originals);
        Assert.Contains(Path, fault);
        Assert.Contains(expected, fault);
    }

    [Fact]
    public void Save_FolderIsNotThere_IsAFaultWithThePath()
    {
        string path = System.IO.Path.Combine(_folder, "none", "originals.json");

        string? fault = new OriginalsFile(path).Save(new Originals(1, [], null));

        Assert.StartsWith($"{path} cannot be written:", fault);
    }
}
