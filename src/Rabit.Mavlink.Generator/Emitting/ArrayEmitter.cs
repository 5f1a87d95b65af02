using System.Linq;

namespace Rabit.Mavlink.Generator.Emitting;

/// <summary>
/// Writes the value type of one kind of array. The elements lie in 64-bit words, so that a copy, a comparison and the
/// garbage collector see a handful of integers; what is done with them is written once, in <c>MavlinkArray</c> and
/// <c>MavlinkText</c> of the package.
/// </summary>
internal static class ArrayEmitter
{
    public static void Emit(SourceWriter writer, ArrayType array)
    {
        string name = array.Name;
        DocComment.Summary(writer, array.IsText
            ? $"A text of at most {array.Length} bytes of UTF-8, kept as sent. A plain value: "
                + "nothing is allocated until <see cref=\"ToString\"/> is asked for."
            : $"{array.Length} elements of {array.Element}. A plain value: a copy is independent of its original. Two "
                + "are equal where all their bits are.");
        writer.Open($"public struct {name} : global::System.IEquatable<{name}>");
        EmitStorage(writer, array);
        EmitConstructors(writer, array);
        EmitAccess(writer, array);
        EmitWire(writer, array);
        EmitEquality(writer, array);
        EmitToString(writer, array);
        writer.Close();
    }

    private static void EmitStorage(SourceWriter writer, ArrayType array)
    {
        writer.Line("// Reached through 'this' as a whole, never one by one.");
        writer.Line("#pragma warning disable 0169");
        writer.Line(
            $"private ulong {string.Join(", ", Enumerable.Range(0, array.Words).Select(index => "_w" + index))};");
        writer.Line("#pragma warning restore 0169");
    }

    private static void EmitConstructors(SourceWriter writer, ArrayType array)
    {
        writer.Blank();
        DocComment.Summary(writer, array.IsText
            ? "Takes bytes as they are; what they do not fill is zero."
            : "Takes elements; what they do not fill is zero.");
        writer.Line($"/// <param name=\"{Items(array)}\">At most {array.Length}.</param>");
        writer.Line("/// <exception cref=\"global::System.ArgumentException\">There are more than "
            + $"{array.Length}.</exception>");
        writer.Open($"public {array.Name}(global::System.ReadOnlySpan<{array.Element}> {Items(array)})");
        writer.Line($"this = default({array.Name});");
        writer.Line($"MavlinkArray.Fill(ref this, {array.Length}, {Items(array)});");
        writer.Close();
        if (!array.IsText)
            return;
        writer.Blank();
        DocComment.Summary(writer, "Takes a text; what it does not fill is zero.");
        writer.Line(
            $"/// <param name=\"text\">At most {array.Length} bytes as UTF-8, no NUL, no half of a surrogate pair.</param>");
        writer.Line("/// <exception cref=\"global::System.ArgumentException\">The text does not fit or holds another "
            + "character; nothing is cut in silence.</exception>");
        writer.Open($"public {array.Name}(string text)");
        writer.Line($"this = default({array.Name});");
        writer.Line($"MavlinkText.Fill(ref this, {array.Length}, text);");
        writer.Close();
    }

    private static void EmitAccess(SourceWriter writer, ArrayType array)
    {
        writer.Blank();
        DocComment.Summary(writer, array.IsText
            ? $"How many bytes it has room for: {array.Length}."
            : $"How many elements it has: {array.Length}.");
        writer.Line($"public int {(array.IsText ? "Capacity" : "Length")} {{ get {{ return {array.Length}; }} }}");
        if (array.IsText)
        {
            writer.Blank();
            DocComment.Summary(writer, "How many bytes the text has: those before the first zero.");
            writer.Line($"public int Length {{ get {{ return MavlinkText.Length(ref this, {array.Length}); }} }}");
        }

        writer.Blank();
        DocComment.Summary(writer, array.IsText ? "One byte, as sent." : "One element.");
        writer.Line($"/// <param name=\"index\">0 to {array.Length - 1}.</param>");
        writer.Line(
            "/// <exception cref=\"global::System.ArgumentOutOfRangeException\">The index is outside.</exception>");
        writer.Open($"public {array.Element} this[int index]");
        writer.Line(
            $"get {{ return MavlinkArray.Get<{array.Name}, {array.Element}>(ref this, {array.Length}, index); }}");
        writer.Line($"set {{ MavlinkArray.Set(ref this, {array.Length}, index, value); }}");
        writer.Close();
        writer.Blank();
        DocComment.Summary(
            writer, array.IsText ? $"Copies all {array.Length} bytes." : $"Copies all {array.Length} elements.");
        writer.Line("/// <param name=\"destination\">Has room for all of them.</param>");
        writer.Line(
            "/// <exception cref=\"global::System.ArgumentException\">The destination is too short.</exception>");
        writer.Line($"public void CopyTo(global::System.Span<{array.Element}> destination) {{ MavlinkArray.CopyTo(ref "
            + $"this, {array.Length}, destination); }}");
    }

    private static void EmitWire(SourceWriter writer, ArrayType array)
    {
        writer.Blank();
        DocComment.Summary(writer, "Reads the elements from a payload, little endian.");
        writer.Line("/// <param name=\"payload\">The payload.</param>");
        writer.Line("/// <param name=\"offset\">Where the first element begins.</param>");
        writer.Line("public void ReadFrom(global::System.ReadOnlySpan<byte> payload, int offset) { "
            + $"MavlinkArray.Read<{array.Name}, {array.Element}>(ref this, {array.Length}, payload, offset); }}");
        writer.Blank();
        DocComment.Summary(writer, "Writes the elements into a payload, little endian.");
        writer.Line("/// <param name=\"payload\">The payload.</param>");
        writer.Line("/// <param name=\"offset\">Where the first element begins.</param>");
        writer.Line("public void WriteTo(global::System.Span<byte> payload, int offset) { "
            + $"MavlinkArray.Write<{array.Name}, {array.Element}>(ref this, {array.Length}, payload, offset); }}");
    }

    private static void EmitEquality(SourceWriter writer, ArrayType array)
    {
        string name = array.Name;
        if (array.IsText)
        {
            writer.Blank();
            DocComment.Summary(writer, "Whether it reads as the given text; allocates nothing.");
            writer.Line("/// <param name=\"text\">What to compare with.</param>");
            writer.Line(
                "/// <returns>True where the bytes before the first zero read as the text.</returns>");
            writer.Line($"public bool TextEquals(string text) {{ return MavlinkText.AreEqual(ref this, {array.Length}, "
                + "text); }");
        }

        writer.Blank();
        writer.Line("/// <inheritdoc/>");
        writer.Line($"public bool Equals({name} other) {{ return MavlinkArray.AreEqual(ref this, ref other); }}");
        writer.Blank();
        writer.Line("/// <inheritdoc/>");
        writer.Line($"public override bool Equals(object obj) {{ return obj is {name} && Equals(({name})obj); }}");
        writer.Blank();
        writer.Line("/// <inheritdoc/>");
        writer.Line($"public override int GetHashCode() {{ return MavlinkArray.Hash(ref this); }}");
        writer.Blank();
        DocComment.Summary(writer, "Whether all bits are equal.");
        writer.Line($"public static bool operator ==({name} left, {name} right) {{ return left.Equals(right); }}");
        writer.Blank();
        DocComment.Summary(writer, "Whether any bit differs.");
        writer.Line($"public static bool operator !=({name} left, {name} right) {{ return !left.Equals(right); }}");
    }

    private static void EmitToString(SourceWriter writer, ArrayType array)
    {
        writer.Blank();
        DocComment.Summary(writer, array.IsText
            ? "The text: the bytes before the first zero, as UTF-8; bytes that are none are the characters of the same "
                + "number (Latin-1)."
            : "The elements between brackets, for logs and the debugger.");
        string call = array.IsText
            ? "MavlinkText.Read(ref this, "
            : $"MavlinkArray.Format<{array.Name}, {array.Element}>(ref this, ";
        writer.Line($"public override string ToString() {{ return {call}{array.Length}); }}");
    }

    private static string Items(ArrayType array) => array.IsText ? "bytes" : "elements";
}
