using System;
using System.Linq;
using Rabit.Mavlink.Generator.Emitting;
using Rabit.Mavlink.Generator.Reading;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Mavlink.Tests.Generator;

public class DialectReaderFuzzTests(ITestOutputHelper output)
{
    private const string Letters = "<>/=\"' &;abcxE_0123456789-*[]\n\0\u20AC";

    [Fact]
    public void Read_DamagedDefinitions_NeverThrows()
    {
        int seed = Environment.TickCount;
        output.WriteLine($"seed {seed}");
        var random = new Random(seed);
        string valid =
            Definitions.PackageFiles.Single(file => file.Path.EndsWith("minimal.xml", StringComparison.Ordinal)).Text;
        for (int round = 0; round < 300; round++)
        {
            char[] text = valid.ToCharArray();
            for (int change = random.Next(1, 6); change > 0; change--)
                text[random.Next(text.Length)] = Letters[random.Next(Letters.Length)];
            var file = new DialectFile(
                "root.xml", new string(text, 0, round % 3 == 0 ? random.Next(text.Length) : text.Length));
            DialectReadResult result = DialectReader.Read(file, [file]);
            Assert.NotEmpty(CSharpEmitter.Emit(result.Dialect, new EmitOptions("Check")));
        }
    }
}
