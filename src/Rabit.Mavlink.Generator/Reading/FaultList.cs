using System.Collections.Generic;
using System.Xml;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Reading;

internal sealed class FaultList
{
    private readonly List<DialectFault> _faults = [];

    public IReadOnlyList<DialectFault> Faults => _faults;

    public static DefinitionPlace PlaceOf(string path, IXmlLineInfo? at) =>
        at is not null && at.HasLineInfo()
            ? new DefinitionPlace(path, at.LineNumber, at.LinePosition)
            : new DefinitionPlace(path, 0, 0);

    public void Add(DialectFaultKind kind, string path, IXmlLineInfo? at, string reason)
        => Add(kind, PlaceOf(path, at), reason);

    public void Add(DialectFaultKind kind, DefinitionPlace place, string reason) =>
        _faults.Add(new DialectFault(kind, place.Path, place.Line, place.Column, reason));

    public void Add(string path, XmlException exception) =>
        _faults.Add(
            new DialectFault(
                DialectFaultKind.Malformed, path, exception.LineNumber, exception.LinePosition, exception.Message));
}
