using System;
using System.Collections.Generic;
using System.Text;

namespace Rabit.Uav.Reporting.Html;

/// <summary>
/// Writes HTML that is well-formed XML too: every text and attribute is escaped, and every element is closed.
/// </summary>
internal sealed class PageWriter
{
    private readonly StringBuilder _text = new();
    private readonly Stack<string> _open = new();

    /// <summary>Begins an element.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="attributes">Name, value, name, value...</param>
    public PageWriter Open(string name, params string[] attributes)
    {
        Tag(name, attributes);
        _text.Append('>');
        _open.Push(name);
        return this;
    }

    /// <summary>Ends the element that was begun last.</summary>
    public PageWriter Close()
    {
        _text.Append("</").Append(_open.Pop()).Append(">\n");
        return this;
    }

    /// <summary>An element with nothing but a text in it.</summary>
    public PageWriter Element(string name, string text, params string[] attributes)
        => Open(name, attributes).Text(text).Close();

    /// <summary>A button that copies a text; the script of the page makes it work.</summary>
    public PageWriter CopyButton(string text, string label)
        => Element("button", "copy", "type", "button", "class", "copy", "data-copy", text, "aria-label", label);

    /// <summary>An element without content: a void one of HTML, or one of SVG.</summary>
    public PageWriter Empty(string name, params string[] attributes)
    {
        Tag(name, attributes);
        _text.Append("/>\n");
        return this;
    }

    /// <summary>A text, from wherever it comes.</summary>
    public PageWriter Text(string text)
    {
        for (int index = 0; index < text.Length; index++)
            AppendEscaped(text, ref index);
        return this;
    }

    /// <summary>A text of our own that is markup, style or script already.</summary>
    public PageWriter Raw(string markup)
    {
        _text.Append(markup);
        return this;
    }

    /// <exception cref="InvalidOperationException">An element is still open.</exception>
    public override string ToString()
        => _open.Count == 0
            ? _text.ToString()
            : throw new InvalidOperationException($"Element '{_open.Peek()}' was not closed.");

    private void Tag(string name, string[] attributes)
    {
        _text.Append('<').Append(name);
        for (int index = 0; index + 1 < attributes.Length; index += 2)
        {
            _text.Append(' ').Append(attributes[index]).Append("=\"");
            Text(attributes[index + 1]);
            _text.Append('"');
        }
    }

    private void AppendEscaped(string text, ref int index)
    {
        char c = text[index];
        if (char.IsHighSurrogate(c) && index + 1 < text.Length && char.IsLowSurrogate(text[index + 1]))
        {
            _text.Append(c).Append(text[++index]);
            return;
        }

        switch (c)
        {
            case '<':
                _text.Append("&lt;");
                break;
            case '>':
                _text.Append("&gt;");
                break;
            case '&':
                _text.Append("&amp;");
                break;
            case '"':
                _text.Append("&quot;");
                break;
            case '\n':
                _text.Append(c);
                break;
            default:
                // What neither HTML nor XML may hold, and what would turn the text of a line around.
                _text.Append(char.IsControl(c) || char.IsSurrogate(c) || IsSteering(c) ? '\uFFFD' : c);
                break;
        }
    }

    private static bool IsSteering(char c)
        => c is >= '\u202A' and <= '\u202E' or >= '\u2066' and <= '\u2069' or '\uFFFE' or '\uFFFF';
}
