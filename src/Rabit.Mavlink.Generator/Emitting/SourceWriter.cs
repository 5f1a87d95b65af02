using System.Text;

namespace Rabit.Mavlink.Generator.Emitting;

/// <summary>
/// Lines of C# with their indentation. Always line feeds, so that the same definitions give the same bytes everywhere.
/// </summary>
internal sealed class SourceWriter
{
    private readonly StringBuilder _text = new();
    private int _depth;

    public void Line(string line)
    {
        _text.Append(' ', 4 * _depth).Append(line).Append('\n');
    }

    public void Blank() => _text.Append('\n');

    public void Open(string line)
    {
        Line(line);
        Line("{");
        _depth++;
    }

    public void Close(string end = "")
    {
        _depth--;
        Line("}" + end);
    }

    public override string ToString() => _text.ToString();
}
