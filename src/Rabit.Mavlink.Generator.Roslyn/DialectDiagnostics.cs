using System.Globalization;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.Text;
using Rabit.Mavlink.Generator.Reading;

namespace Rabit.Mavlink.Generator.Roslyn;

/// <summary>
/// Turns a fault into a compiler error or warning at its line: RABMAV001 for the first kind, and so on.
/// </summary>
internal static class DialectDiagnostics
{
    public static Diagnostic From(DialectFault fault)
    {
        var start = new LinePosition(fault.Line > 0 ? fault.Line - 1 : 0, fault.Column > 0 ? fault.Column - 1 : 0);
        Location location = Location.Create(fault.Path, default, new LinePositionSpan(start, start));
        DiagnosticSeverity severity = fault.IsWarning ? DiagnosticSeverity.Warning : DiagnosticSeverity.Error;
        return Diagnostic.Create(
            Id(fault.Kind), "Rabit.Mavlink", fault.Reason, severity, severity,
            isEnabledByDefault: true, warningLevel: fault.IsWarning ? 1 : 0, title: "MAVLink definition",
            location: location);
    }

    private static string Id(DialectFaultKind kind)
        => "RABMAV" + ((int)kind).ToString("000", CultureInfo.InvariantCulture);
}
