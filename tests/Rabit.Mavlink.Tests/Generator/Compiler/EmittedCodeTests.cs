using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Rabit.Mavlink.Generator.Emitting;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Generator.Compiler;

public class EmittedCodeTests
{
    [Theory]
    [InlineData("minimal.xml")]
    [InlineData("all.xml")]
    public void Emit_PackageDialects_CompileAsCSharp73(string file) => AssertCompiles(Definitions.Package(file));

    [Fact]
    public void Emit_AwkwardNamesAndDescriptions_CompileAsCSharp73()
        => AssertCompiles(Definitions.Read(("my-own.xml", """
        <enums>
          <enum name="SPAN" bitmask="true"><description>A &lt;b&gt; &amp; "c" */ </description><entry name="SPAN_1" value="2**63"/></enum>
          <enum name="SYSTEM"><entry name="class" value="-1"/><entry name="SYSTEM_2" value="4294967295"><description>a</description></entry></enum>
          <enum name="EMPTY"/>
        </enums>
        <messages>
          <message id="70000" name="CONSOLE"><description>Says &lt;what&gt; it &amp; does</description>
            <field type="uint8_t" name="class" enum="SYSTEM" units="m/s" minValue="0" maxValue="9" invalid="&lt;0"/>
            <field type="int8_t" name="console" enum="SPAN">&lt;x&gt;</field>
            <field type="char" name="letter"/><field type="char[3]" name="system"/><field type="double[2]" name="span" enum="SPAN"/>
            <field type="float" name="payload" enum="SPAN"/><field type="int64_t" name="equals"/>
            <extensions/><field type="uint64_t[1]" name="more"/>
          </message>
        </messages>
        """)).Dialect);

    [Fact]
    public void Emit_OwnDialectAbovePackage_CompilesAsCSharp73()
    {
        Dialect dialect = Definitions.ReadWithPackage(("acme.xml", """
            <include>company.xml</include>
            <enums><enum name="MAV_CMD"><entry name="MAV_CMD_ACME_DIG" value="48001"/></enum></enums>
            <messages>
              <message id="70000" name="HEARTBEAT_TWO"><field type="uint8_t" name="type" enum="MAV_TYPE"/><field type="uint16_t" name="command" enum="MAV_CMD"/>
                <field type="uint64_t" name="wide" enum="MAV_STATE"/><field type="float[4]" name="q"/><field type="double[7]" name="r"/></message>
            </messages>
            """), ("company.xml", "<include>common.xml</include>"));
        AssertCompiles(dialect, new EmitOptions("Check.Messages") { Existing = Definitions.Existing });
        Assert.Equal(
            ["DoubleArray7", "MavState", "AcmeMavCmd", "HeartbeatTwo", "AcmeDialect.Instance"],
            CSharpEmitter.Emit(dialect, new EmitOptions("A") { Existing = Definitions.Existing })
                .Select(source => source.Name.Replace(".g.cs", "", StringComparison.Ordinal)));
    }

    [Fact]
    public void Emit_EntriesAddedToAnEnumOfThePackage_AreConstantsOfItsType()
    {
        Dialect dialect = Definitions.ReadWithPackage(("acme.xml", """
            <include>common.xml</include>
            <enums>
              <enum name="MAV_CMD"><entry name="MAV_CMD_ACME_DIG" value="48001"/><entry name="MAV_CMD_EQUALS" value="48002"/></enum>
              <enum name="MAV_SYS_STATUS_SENSOR_EXTENDED" bitmask="true"><entry name="MAV_SYS_STATUS_ACME" value="2**31"/></enum>
            </enums>
            """));
        Assembly assembly = Assembly.Load(
            Compile(dialect, new EmitOptions("Check.Messages") { Existing = Definitions.Existing }));
        Type commands = assembly.GetType("Check.Messages.AcmeMavCmd", throwOnError: true)!;

        Assert.Equal(
            (MavCmd)48_001, commands.GetField("AcmeDig")!.GetRawConstantValue() is int dig ? (MavCmd)dig : default);
        Assert.Equal(typeof(MavCmd), commands.GetField("AcmeDig")!.FieldType);
        Assert.Equal(["AcmeDig", "EqualsEntry"], commands.GetFields().Select(field => field.Name));
        Assert.Equal(
            ["AcmeDialect", "AcmeMavCmd", "AcmeMavSysStatusSensorExtended"],
            assembly.GetExportedTypes().Select(type => type.Name).Order(StringComparer.Ordinal));
    }

    [Fact]
    public void Emit_EnumThatOnlySharesItsNameWithOneOfThePackage_IsATypeOfItsOwn()
    {
        Dialect dialect =
            Definitions.ReadEnums("<enum name='MAV_STATE'><entry name='MAV_STATE_ASLEEP' value='1'/></enum>").Dialect;
        Assert.Contains(
            "MavState.g.cs",
            CSharpEmitter.Emit(dialect, new EmitOptions("A") { Existing = Definitions.Existing })
                .Select(source => source.Name));
    }

    [Fact]
    public void Instance_OwnDialectAbovePackage_KnowsItsOwnAndThePackages()
    {
        Dialect dialect = Definitions.ReadWithPackage(("acme.xml", """
            <include>common.xml</include>
            <enums><enum name="MAV_CMD"><entry name="MAV_CMD_ACME_DIG" value="48001"/></enum></enums>
            <messages><message id="70000" name="DIG"><field type="float" name="depth" units="&#xB5;m" invalid="NaN"/><field type="uint16_t" name="why" enum="MAV_CMD"/></message></messages>
            """));
        Assembly assembly = Assembly.Load(
            Compile(dialect, new EmitOptions("Check.Messages") { Existing = Definitions.Existing }));
        var acme = (MavlinkDialect)assembly.GetType(
            "Check.Messages.AcmeDialect", throwOnError: true)!.GetProperty("Instance")!.GetValue(null)!;

        Assert.Equal(("acme", MavlinkDialect.Common.Count + 1), (acme.Name, acme.Count));
        MavlinkMessageDefinition dig = acme.FindDefinition(70_000)!;
        Assert.Equal(("\u00B5m", "NaN"), (dig.FindField("depth")!.Units, dig.FindField("depth")!.Invalid));
        foreach (MavlinkEnumDefinition? commands in new[]
        {
            dig.FindField("why")!.Enum, acme.FindDefinition(CommandLong.MavlinkId)!.FindField("command")!.Enum
        })
        {
            Assert.Equal("MAV_CMD_ACME_DIG", commands!.NameOf(48_001));
            Assert.Equal("MAV_CMD_NAV_WAYPOINT", commands.NameOf(16));
        }

        MavlinkDialect both = MavlinkDialect.Combine("both", MavlinkDialect.ArduPilotMega, acme);
        Assert.Equal(MavlinkDialect.ArduPilotMega.Count + 1, both.Count);
        Assert.Equal("MAV_CMD_ACME_DIG", both.FindDefinition(70_000)!.FindField("why")!.Enum!.NameOf(48_001));
        Assert.Null(MavlinkDialect.All.FindEnum("MAV_CMD")!.NameOf(48_001));
    }

    [Fact]
    public void Emit_CopyOfAPackageMessage_EmitsItOnlyWhereItDiffers()
    {
        const string Same = "<message id='2' name='SYSTEM_TIME'><field type='uint64_t' name='time_unix_usec'/><field "
            + "type='uint32_t' name='time_boot_ms'/>";
        Assert.DoesNotContain("SystemTime.g.cs", EmitMessages($"{Same}</message>"));
        Assert.Contains(
            "SystemTime.g.cs", EmitMessages($"{Same}<extensions/><field type='uint8_t' name='more'/></message>"));
    }

    [Fact]
    public void Emit_Twice_GivesTheSameText()
    {
        var options = new EmitOptions("Check");
        Assert.Equal(
            CSharpEmitter.Emit(Definitions.Package("common.xml"), options),
            CSharpEmitter.Emit(Definitions.Package("common.xml"), options));
    }

    [Fact]
    public void Emit_Sources_HaveNamesUniqueWithoutCase()
    {
        IReadOnlyList<GeneratedSource> sources = CSharpEmitter.Emit(Definitions.All, new EmitOptions("Check"));
        Assert.Equal(
            sources.Count, sources.Select(source => source.Name).Distinct(StringComparer.OrdinalIgnoreCase).Count());
        Assert.All(
            sources, source => Assert.StartsWith("// <auto-generated/>\n", source.Text, StringComparison.Ordinal));
    }

    private static IEnumerable<string> EmitMessages(string messages) =>
        CSharpEmitter.Emit(
            Definitions.ReadMessages(messages).Dialect, new EmitOptions("A") { Existing = Definitions.Existing })
            .Select(source => source.Name);

    private static void AssertCompiles(Dialect dialect) => AssertCompiles(dialect, new EmitOptions("Check.Messages"));

    private static void AssertCompiles(Dialect dialect, EmitOptions options)
        => Assert.NotEmpty(Compile(dialect, options));

    private static byte[] Compile(Dialect dialect, EmitOptions options)
    {
        // Docs are checked too: a public member without one, or a reference to nothing, is a warning here.
        CSharpParseOptions parse = new CSharpParseOptions(LanguageVersion.CSharp7_3, DocumentationMode.Diagnose);
        IEnumerable<SyntaxTree> trees = CSharpEmitter.Emit(dialect, options)
            .Select(source => CSharpSyntaxTree.ParseText(source.Text, parse));
        var compilation = CSharpCompilation.Create(
            "Check", trees, References(),
            new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, checkOverflow: true, warningLevel: 9999));
        using var assembly = new MemoryStream();
        Assert.Empty(
            compilation.Emit(assembly, xmlDocumentationStream: new MemoryStream()).Diagnostics
                .Where(diagnostic => diagnostic.Severity >= DiagnosticSeverity.Warning));
        return assembly.ToArray();
    }

    private static IEnumerable<MetadataReference> References() =>
        ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator)
            .Where(
                path => Path.GetFileName(path).StartsWith("System.", StringComparison.Ordinal)
                    || Path.GetFileName(path) is "netstandard.dll")
            .Append(typeof(IMavlinkMessage).Assembly.Location)
            .Select(path => MetadataReference.CreateFromFile(path));
}
