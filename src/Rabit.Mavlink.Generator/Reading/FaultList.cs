using System.Collections.Generic;
using System.Xml;

namespace Rabit.Mavlink.Generator.Reading;

internal sealed class FaultList
{
    private readonly List<DialectFault> _faults = [];

    public IReadOnlyList<DialectFault> Faults => _faults;

    public void Add(DialectFaultKind kind, string path, IXmlLineInfo? at, string reason)
    {
        bool known = at is not null && at.HasLineInfo();
        _faults.Add(new DialectFault(kind, path, known ? at!.LineNumber : 0, known ? at!.LinePosition : 0, reason));
    }

    public void Add(string path, XmlException exception) =>
        _faults.Add(new DialectFault(DialectFaultKind.Malformed, path, exception.LineNumber, exception.LinePosition, exception.Message));
}
