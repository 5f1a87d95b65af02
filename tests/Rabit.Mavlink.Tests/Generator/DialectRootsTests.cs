using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Generator.Reading;
using Xunit;

namespace Rabit.Mavlink.Tests.Generator;

public class DialectRootsTests
{
    [Fact]
    public void Of_FilesThatIncludeEachOther_AreThoseThatNoneIncludes() =>
        Assert.Equal(["top.xml", "alone.xml"], Roots(
            ("base.xml", ""), ("top.xml", "common.xml middle.xml"), ("middle.xml", "base.xml"),
            ("alone.xml", "common.xml")));

    [Fact]
    public void Of_TwoThatShareAnInclude_AreBothRoots() =>
        Assert.Equal(["one.xml", "two.xml"], Roots(("one.xml", "base.xml"), ("two.xml", "BASE.xml"), ("base.xml", "")));

    [Fact]
    public void Of_Cycles_GiveTheFirstOfEach() =>
        Assert.Equal(
            ["self.xml", "top.xml", "a.xml"],
            Roots(
                ("a.xml", "b.xml"), ("b.xml", "a.xml"), ("self.xml", "self.xml"), ("top.xml", "c.xml"),
                ("c.xml", "d.xml"), ("d.xml", "c.xml")));

    [Fact]
    public void Of_BrokenFiles_AreRootsThatCountAsFarAsTheyGo()
    {
        var broken = new DialectFile("broken.xml", "<mavlink><include>base.xml</include><");
        Assert.Equal([broken], DialectRoots.Of([new DialectFile("base.xml", "<mavlink/>"), broken]));
    }

    private static IEnumerable<string> Roots(params (string Name, string Includes)[] files)
        => DialectRoots.Of(files.Select(file => new DialectFile(
            file.Name, "<mavlink>"
                + string.Concat(
                    file.Includes.Split(' ').Where(name => name.Length != 0)
                        .Select(name => $"<include>{name}</include>"))
                + "</mavlink>")).ToList())
            .Select(file => file.Path);
}
